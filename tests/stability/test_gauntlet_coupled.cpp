// Hard cases of water and solid together, short, and pairing. The scenes are those of benchmarks/stability.
#include "margins.hpp"
#include "stability/coupled.hpp"
#include "stability/crowd.hpp"

using namespace gauntlet;
using stability::SoundCoupling;

TEST_CASE("Water falls on an elastic plate", "[stability]") {
    check_margin(stability::water_on_plate<SoundCoupling>, 1);
    check_noticed(stability::water_on_plate<SoundCoupling>, 1);
}

TEST_CASE("A block much lighter than water is let go on a pool", "[stability]") { // row 8
    check_margin(stability::light_block<SoundCoupling>, 0.1);
}

TEST_CASE("In free fall nothing moves against anything else", "[stability]") { // row 21
    const Outcome paper = stability::free_fall<stability::PaperCoupling>({.cfl = 0.4});
    INFO(words(paper));
    CHECK(paper.stable);
    CHECK(paper.signs[0].worst < 1e-12);
    CHECK(paper.signs[1].worst < 1e-12);
    check_margin(stability::free_fall<SoundCoupling>); // not exactly, see free_fall
}

TEST_CASE("Fifty neighbours pair up with a cubic spline, and not with a Wendland kernel", "[stability]") { // row 2
    check_margin(stability::crowded<imbibe::WendlandC2>);
    const Outcome spline = stability::crowded<imbibe::CubicSpline>(Plan{.cfl = 0.4});
    INFO(words(spline));
    CHECK(!spline.stable);
}
