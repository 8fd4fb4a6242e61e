// A few hard cases of each kind for the ordinary tests: a fluid, a solid, and both together. All of them, in all their
// compositions, are in more/.
#include "margins.hpp"
#include <cases/stability/coupled.hpp>
#include <cases/stability/fluids.hpp>
#include <cases/stability/solids.hpp>

using namespace gauntlet;
using stability::Hookean;
using stability::SoundCoupling;
using stability::WeaklyCompressible;

TEST_CASE("Water that is shaken, stands, and hits a floor is stable", "[stability]") {
    check_preset(stability::shaken_water<WeaklyCompressible>);
    check_preset(stability::still_water<WeaklyCompressible>);
    check_preset(stability::impact<WeaklyCompressible>, 0.3);
}

TEST_CASE("A bar that is stretched and a beam that swings are stable", "[stability]") {
    check_preset(stability::stretched_bar<Hookean>, 0.15);
    check_preset(stability::bent_beam<Hookean>, 0.3);
}

TEST_CASE("Water that falls on a plate, and a block on a pool, are stable, and a step too long is noticed",
          "[stability]") {
    check_preset(stability::water_on_plate<SoundCoupling>, 1);
    check_noticed(stability::water_on_plate<SoundCoupling>, 1);
    check_preset(stability::block_on_pool<SoundCoupling>, 0.1);
}
