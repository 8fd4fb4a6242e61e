// What is one particle thick: walls under a metre of water, sheets and threads, slots. Rows 4, 10 and 17 of the
// gauntlet.
#include "margins.hpp"
#include "stability/thin.hpp"

using namespace gauntlet;
using stability::Riemann;
using stability::Unguarded;
using stability::WeaklyCompressible;

TEST_CASE("Walls of two layers hold the pressure of four metres of water, of one layer that of one metre",
          "[stability]") {
    // row 10
    check_preset(stability::thin_wall<WeaklyCompressible, 2>, 4);
    check_margin(stability::thin_wall<Riemann, 2>, 4);
    check_preset(stability::thin_wall<WeaklyCompressible, 1>, 1);
    // docs/stability.md says so: without the guard one layer does not
    CHECK(!stability::thin_wall<Unguarded, 1>({.value = 1}).stable);
    CHECK(!stability::thin_wall<Riemann, 1>({.value = 1}).stable);
}

TEST_CASE("A drop thrown on an upright wall falls along it as if it were not there", "[stability]") {
    for (const double speed : {0.001, 0.003, 0.01, 0.03}) // of sound
        check_preset(stability::drop_along_wall<WeaklyCompressible>, speed);
}

TEST_CASE("A floor with slots of 0.4 spacings bears the water, and one with wide slots drains", "[stability]") {
    const Outcome closed = stability::slotted_floor<WeaklyCompressible>({.value = 0.4}); // row 17
    INFO(words(closed));
    CHECK(closed.stable);
    CHECK(closed.signs[0].worst == 0);
    const Outcome open = stability::slotted_floor<WeaklyCompressible>({.value = 3});
    CHECK(open.signs[0].worst > 0);
}
