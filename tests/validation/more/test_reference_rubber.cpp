// Rubber that spins, and bends under its weight and under water, as in cases/validation, coarse;
// docs/validation.md has it finer.
#include <cases/validation/elastic_baffle.hpp>
#include <cases/validation/elastic_gate.hpp>
#include <cases/validation/spinning_plate.hpp>
#include <cases/validation/turek_hron.hpp>
#include <catch_shim.hpp>
#include <sanitized.hpp>

#include <cmath>

TEST_CASE("A spinning plate keeps its angular momentum", "[validation][solid]") {
    const int turns = 10;
    const double spacing = 1.0 / 20, omega = 50, density = 1100;
    const auto seen = validation::spinning_plate::spin(20, turns);
    // The moment of inertia of the square, less the part of the particles' own: density a^4/6 (1 - (spacing/a)^2)
    REQUIRE(seen.momentum_start == Approx(omega * density / 6 * (1 - spacing * spacing)).epsilon(1e-12));
    const auto &early = seen.stress_early, &late = seen.stress_late; // in rho omega^2 R^2
    CAPTURE(early.mean, late.mean, early.greatest_mean, late.greatest_mean, early.greatest_anywhere,
            late.greatest_anywhere);
    CAPTURE(seen.steps, 1e15 * seen.momentum_drift, seen.energy_drift, seen.turned, seen.early, seen.late);
    CHECK(seen.momentum_drift < 1e-3);  // what the reference asks for
    CHECK(seen.momentum_drift < 1e-10); // what these forces and this integrator promise: round-off
    // The plate stretches under its own spin, which slows it, and it swings about the stretched shape: of 10 turns of
    // the rigid plate it makes fewer, but not half as many.
    CHECK(seen.turned > 0.5 * turns);
    CHECK(seen.turned < turns);
    CHECK(seen.late < 1.05 * seen.early); // the swings do not grow
    CHECK(seen.energy_drift < 0.01);      // without the energy of the hourglass control
    // Nor does the stress, which is to drift by less than 1 %. The greatest at single particles and steps, where many
    // vibrations meet, is no measure of that: 5 % more late than early with 20 particles along a side, 1 % with 40.
    CHECK(early.mean > 0.05); // the spin does strain it
    CHECK(std::abs(late.mean - early.mean) < 0.01);
    CHECK(std::abs(late.greatest_mean - early.greatest_mean) < 0.01);
}

TEST_CASE("The stiffer beam of Turek and Hron hangs as theirs does", "[validation][solid]") { // CSM2
    const auto end = validation::turek_hron::hang(4, imbibe::bending_modulus(5.6e6, 4));
    CAPTURE(end[0], end[1]);
    CHECK(end[0] == Approx(-0.469006e-3).epsilon(0.03));
    CHECK(end[1] == Approx(-16.9740e-3).epsilon(0.03));
}

TEST_CASE("Water bends an elastic baffle as far as other codes have it", "[validation][coupling]") {
    const auto peak = validation::elastic_baffle::strike(3);
    CAPTURE(peak.aside, peak.time);
    CHECK(peak.aside > 0.045);
    CHECK(peak.aside < 0.05);
    CHECK(peak.time > 0.24);
    CHECK(peak.time < 0.26);
}

// With ten particles over its thickness the gate goes 43 mm aside and 15 mm up, in the experiment 45 and 18 to 20; the
// bound on this coarse one's way up was chosen after a run.
TEST_CASE("Water opens a rubber gate, not quite as far as in the experiment", "[validation][coupling]") {
    if (imbibe_test::left_out("what it is made of has run in the baffle"))
        return;
    const auto way = validation::elastic_gate::open(3, 7.8e6, 0.47, 0.16);
    CAPTURE(way.greatest[0], way.greatest[1], way.time);
    CHECK(way.greatest[0] == Approx(0.045).epsilon(0.15)); // 5 to 10 % were asked for, of a finer one
    CHECK(way.greatest[1] == Approx(0.019).epsilon(0.35));
    CHECK(way.time > 0.10);
    CHECK(way.time < 0.16);
}
