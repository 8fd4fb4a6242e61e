// Hard cases of fluids, short. The scenes are those of cases/stability, which bisects how much harder they may be.
#include "margins.hpp"
#include <cases/stability/fluids.hpp>

using namespace gauntlet;
using stability::DamBreak;
using stability::Paper;
using stability::Riemann;
using stability::WeaklyCompressible;

namespace gauntlet_of_fluids {
/// The paper's fluid with more neighbours.
struct WidePaper : Paper {
    static constexpr double support = 2.6; // spacings
};
} // namespace gauntlet_of_fluids

TEST_CASE("Water shaken particle by particle comes to rest", "[stability]") {
    check_preset(stability::shaken_water<WeaklyCompressible>);
    check_margin(stability::shaken_water<Riemann>);
}

TEST_CASE("Still water stays still, with a smooth pressure", "[stability]") { // rows 5 and 20
    check_preset(stability::still_water<WeaklyCompressible>);
    check_margin(stability::still_water<Riemann>);
}

TEST_CASE("A block of water hits a floor", "[stability]") { // row 7
    check_margin(stability::impact<Riemann>, 0.08);
    check_preset(stability::impact<WeaklyCompressible>, 0.3);
    check_margin(stability::impact<DamBreak>, 0.3);
    // The density rises by no more than 5 % where water hammer, v/c, does not ask for more.
    const Outcome slow = stability::impact<WeaklyCompressible>({.cfl = 0.75, .value = 0.05});
    INFO(words(slow));
    CHECK(slow.stable);
    REQUIRE(slow.signs[2].name == "greatest rise of a density");
    CHECK(slow.signs[2].worst < 0.05);
}

TEST_CASE("A spinning square of water stays free of clumps and voids", "[stability]") { // rows 1 and 6
    check_preset(stability::spinning_square<WeaklyCompressible>);
    check_preset(stability::spinning_square<WeaklyCompressible, double, true>);
}

TEST_CASE("What opens a void in the paper's spinning square is its narrow support", "[stability]") { // row 6
    const Outcome narrow = stability::spinning_square<Paper, double, true>({.cfl = 0.4});
    CHECK(narrow.cause == narrow.signs[0].name);
    check_stable(stability::spinning_square<gauntlet_of_fluids::WidePaper, double, true>, 0.4, 0);
}

TEST_CASE("A drop splashes into a pool", "[stability]") { // row 19
    check_preset(stability::splash<WeaklyCompressible>);
    check_margin(stability::splash<Riemann>);
    check_margin(stability::splash<DamBreak>);
}

TEST_CASE("Small drops that have come off fly on", "[stability]") { // row 19
    check_preset(stability::drops_in_flight<WeaklyCompressible>, 0.2);
    check_margin(stability::drops_in_flight<Riemann>, 0.2);
    check_margin(stability::drops_in_flight<DamBreak>, 0.2);
}

TEST_CASE("Steps of 2, 5 and 20 times the limit of a fluid are noticed", "[stability]") { // row 13
    check_noticed(stability::splash<WeaklyCompressible>);
    check_noticed(stability::splash<Riemann>);
    check_noticed(stability::impact<Riemann>, 0.1);
}
