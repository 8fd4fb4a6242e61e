// Hard cases of water and solid together, short. The scenes are those of benchmarks/stability.
#include "margins.hpp"
#include "stability/coupled.hpp"

using namespace gauntlet;
using stability::PaperCoupling;
using stability::SoundCoupling;

TEST_CASE("Water falls on an elastic plate", "[stability]") {
    check_preset(stability::water_on_plate<SoundCoupling>, 1);
    check_noticed(stability::water_on_plate<SoundCoupling>, 1);
    check_noticed(stability::water_on_plate<PaperCoupling>, 1);
}

TEST_CASE("A block much lighter than water is let go on a pool", "[stability]") { // row 8
    for (const double density : {0.1, 0.05, 0.02}) // 0.05 is asked for; docs/stability.md goes to 0.002
        check_preset(stability::light_block<SoundCoupling>, density);
}

TEST_CASE("In free fall next to nothing moves against anything else", "[stability]") { // row 21; see free_fall
    check_preset(stability::free_fall<SoundCoupling>);
}
