// What is one particle thick: walls under a metre of water, sheets and threads, slots. Rows 4, 10 and 17 of the
// gauntlet.
#include "margins.hpp"
#include "stability/thin.hpp"

using namespace gauntlet;
using stability::Guarded;
using stability::Riemann;
using stability::WeaklyCompressible;

TEST_CASE("Walls of two layers, or of one with a stiff guard, hold the pressure of four metres of water",
          "[stability]") {
    // row 10
    check_margin(stability::thin_wall<WeaklyCompressible, 2>, 4);
    check_margin(stability::thin_wall<Riemann, 2>, 4);
    check_margin(stability::thin_wall<Guarded, 1>, 4);
    // docs/stability.md says so: one layer alone does not
    CHECK(!stability::thin_wall<WeaklyCompressible, 1>({.value = 1}).stable);
    CHECK(!stability::thin_wall<Riemann, 1>({.value = 1}).stable);
}

TEST_CASE("A floor with slots half a spacing wide bears the water, and one with wide slots drains", "[stability]") {
    const Outcome closed = stability::slotted_floor<WeaklyCompressible>({.value = 0.5}); // row 17
    INFO(words(closed));
    CHECK(closed.stable);
    CHECK(closed.signs[0].worst == 0);
    const Outcome open = stability::slotted_floor<WeaklyCompressible>({.value = 3});
    CHECK(open.signs[0].worst > 0);
}
