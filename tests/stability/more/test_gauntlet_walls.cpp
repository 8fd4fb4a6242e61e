// What is one particle thick: walls under a metre of water, sheets and threads, slots. Rows 4, 10 and 17 of the
// gauntlet.
#include "margins.hpp"
#include <cases/stability/pores.hpp>
#include <cases/stability/thin.hpp>

using namespace gauntlet;
using stability::Pore;
using stability::Riemann;
using stability::SoundCoupling;
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
    // row 17: none leaks, and the pressure on the lid of the pores is rho g h
    check_preset(stability::slotted_floor<WeaklyCompressible>, 0.4);
    check_margin(stability::slotted_floor<Riemann>, 0.4);
    const Outcome open = stability::slotted_floor<WeaklyCompressible>({.value = 3});
    CHECK(open.signs[0].worst > 0);
}

TEST_CASE("A pore that closes under load ends the run, with water in it and without", "[stability]") { // row 17
    const auto check = [](const auto& squeezed) {
        check_preset(squeezed, 1.5); // from 4 spacings to 2.5
        const Outcome closed = squeezed({.value = 2.5});
        INFO(words(closed));
        CHECK(closed.cause == "narrow pore");
        CHECK_THAT(closed.message,
                   imbibe_test::contains("a pore of phase Sponge at (") && imbibe_test::contains("particles of Water"));
    };
    check(stability::squeezed_pore<SoundCoupling, Pore::wet>);
    check(stability::squeezed_pore<SoundCoupling, Pore::dry>);
}
