// One liquid with surface tension and nothing around it, coarse: drops that swing, that lie on walls and on a soft
// slab, that merge; levels between plates; a slit that fills.
#include <cases/validation/free_drop.hpp>
#include <cases/validation/wetting_drop.hpp>
#include <cases/validation/wetting_filling.hpp>
#include <cases/validation/wetting_rise.hpp>
#include <cases/validation/wetting_slab.hpp>

#include <catch_shim.hpp>

#include <algorithm>
#include <cmath>

TEST_CASE("A free drop swings with Lamb's period, under Laplace's pressure", "[fluid]") {
    const auto seen = validation::free_drop::swing<2>(16, 8);
    CAPTURE(seen.period, seen.pressure, seen.damping);
    CHECK(std::abs(seen.period - 1) < 0.03);
    CHECK(std::abs(seen.pressure - 1) < 0.05);
    CHECK(seen.damping > 0.9);
    CHECK(seen.damping < 1.6);
}

TEST_CASE("A free ball swings with Lamb's period", "[fluid]") {
    const auto seen = validation::free_drop::swing<3>(8, 4);
    CAPTURE(seen.period);
    CHECK(std::abs(seen.period - 1) < 0.07);
}

TEST_CASE("A square becomes a disc and lies still", "[fluid]") {
    const auto round = validation::free_drop::square(16);
    CAPTURE(round.least, round.most, round.speed);
    CHECK(round.least > 0.99);
    CHECK(round.most < 1.01);
    CHECK(round.speed < 0.01);
}

TEST_CASE("A drop on a wall comes to its angle, above 80 degrees from either side", "[fluid]") {
    namespace drops = validation::wetting_drop;
    const double advancing = drops::contact_angle(16, 90, 120), receding = drops::contact_angle(16, 90, 60);
    CAPTURE(advancing, receding);
    CHECK(std::abs(advancing - 90) < 5);
    CHECK(std::abs(receding - 90) < 5);
    const double flat = drops::contact_angle(16, 30, 60), steep = drops::contact_angle(16, 120, 90),
                 in_space = drops::contact_angle<3>(6, 90, 120);
    CAPTURE(flat, steep, in_space);
    CHECK(std::abs(in_space - 90) < 5);
    CHECK(std::abs(flat - 30) < 5);
    CHECK(std::abs(steep - 120) < 5);
}

TEST_CASE("A level between plates rises to Jurin's from below and falls to it from above", "[fluid]") {
    namespace plates = validation::wetting_rise;
    const double exact = plates::exact(60), below = plates::rise(12, 60, 0.5 * exact),
                 above = plates::rise(12, 60, 1.5 * exact), pressed = plates::rise(12, 120, -0.5 * exact);
    CAPTURE(below, above, pressed, exact);
    CHECK(std::abs(below / exact - 1) < 0.08);
    CHECK(std::abs(above / exact - 1) < 0.08);
    CHECK(std::abs(pressed / exact + 1) < 0.08);
}

TEST_CASE("A slit fills at Washburn's speed with the angle of a moving line by Cox", "[fluid]") {
    namespace slit = validation::wetting_filling;
    const double found = slit::speed(8, 60), still = slit::exact(60), moving = slit::exact(60, slit::slip / 8);
    CAPTURE(found, still, moving);
    CHECK(std::abs(found / still - 1) < 0.25);
    CHECK(std::abs(found / moving - 1) < 0.08);
}

TEST_CASE("A drop without a gas dents a soft slab and lifts it at its rim", "[fluid]") {
    const auto found = validation::wetting_slab::measure(12);
    CAPTURE(found[0].computed, found[1].computed);
    CHECK(std::abs(found[0].error()) < 0.2); // the wetted surface sinks by itself, by a seventh of the dent
    CHECK(std::abs(found[1].error()) < 0.1);
}

TEST_CASE("Two free drops that touch become one, which swings and comes to rest round", "[fluid]") {
    namespace drops = validation::free_drop;
    auto scene = drops::drop<2>(12, 0.05, [](const auto& x) { return std::hypot(std::abs(x[0]) - 0.7, x[1]) < 0.7; });
    const auto length_over_height = [&] {
        const auto x = scene.get<drops::Water>()[imbibe::position];
        const auto spread = [](const auto& column) { return (column.array() - column.mean()).square().mean(); };
        return std::sqrt(spread(x.col(0)) / spread(x.col(1)));
    };
    double least = 9;
    scene.run_until(scene.time() + 4, [&](const auto&) { least = std::min(least, length_over_height()); });
    CHECK(least < 0.8); // past the circle
    scene.run_until(scene.time() + 20);
    CHECK(std::abs(length_over_height() - 1) < 0.05);
}
