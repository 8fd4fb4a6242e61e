// Hard cases of water and solid together, short. The scenes are those of cases/stability.
#include "margins.hpp"
#include <cases/stability/coupled.hpp>

using namespace gauntlet;
using stability::PaperCoupling;
using stability::SoundCoupling;
using stability::SoundCouplingFiner;

TEST_CASE("Water falls on an elastic plate", "[stability]") {
    check_preset(stability::water_on_plate<SoundCoupling>, 1);
    check_preset(stability::water_on_plate<SoundCouplingFiner>, 1);
    check_noticed(stability::water_on_plate<SoundCoupling>, 1);
    check_noticed(stability::water_on_plate<PaperCoupling>, 1);
}

TEST_CASE("A block much lighter or heavier than water is let go on a pool", "[stability]") { // row 8
    for (const double density : {10.0, 3.0, 0.1, 0.05, 0.02}) // asked for: 10 to 0.05; docs/stability.md goes further
        check_preset(stability::block_on_pool<SoundCoupling>, density);
    for (const double density : {10.0, 1.0, 0.1})
        check_preset(stability::block_on_pool<SoundCouplingFiner>, density);
    check_preset(stability::block_on_pool<SoundCoupling, float>, 10);
    check_margin(stability::block_on_pool<PaperCoupling>, 10);
}

TEST_CASE("In free fall next to nothing moves against anything else", "[stability]") { // row 21; see free_fall
    check_preset(stability::free_fall<SoundCoupling>);
}
