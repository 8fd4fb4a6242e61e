// Two liquids that do not mix: finer; a bubble and water that rise; drops that merge.
#include <cases/validation/capillary_filling.hpp>
#include <cases/validation/capillary_rise.hpp>
#include <cases/validation/capillary_tube.hpp>
#include <cases/validation/capillary_wave.hpp>
#include <cases/validation/drop_in_gas.hpp>
#include <cases/validation/drop_on_slab.hpp>
#include <cases/validation/rising_bubble.hpp>
#include <cases/validation/sessile_drop.hpp>
#include <cases/validation/still_layers.hpp>

#include <catch_shim.hpp>

#include <algorithm>
#include <cmath>

TEST_CASE("A wave on an interface converges", "[fluid]") {
    const double exact = validation::capillary_wave::exact().period;
    const double coarse = std::abs(validation::capillary_wave::wave(32).period / exact - 1),
                 fine = std::abs(validation::capillary_wave::wave(64).period / exact - 1);
    CAPTURE(coarse, fine);
    CHECK(fine < 0.04);
    CHECK(fine < 0.7 * coarse);
}

TEST_CASE("A bubble rises as that of Hysing and others", "[fluid]") {
    const auto found = validation::rising_bubble::rise(32);
    CAPTURE(found.height, found.speed, found.when, found.circularity);
    CHECK(std::abs(found.height / 1.081 - 1) < 0.012);
    CHECK(std::abs(found.speed / 0.2417 - 1) < 0.03);
    CHECK(std::abs(found.circularity / 0.901 - 1) < 0.08); // too flat, at 64 as well
}

TEST_CASE("Water rises between plates, or falls, to about the same level from above as from below", "[fluid]") {
    namespace plates = validation::capillary_rise;
    const double exact = plates::exact(60), below = plates::rise(12, 60, 0), above = plates::rise(12, 60, 1.3 * exact);
    CAPTURE(below, above, exact);
    CHECK(std::abs(below / exact - 1) < 0.08);
    CHECK(std::abs(above / exact - 1) < 0.2); // the line is slow to go back with so few particles
    CHECK(std::abs(plates::rise(12, 120, 0) / exact + 1) < 0.12);
}

TEST_CASE("Water rises in a round tube", "[fluid]") {
    const auto tube = validation::capillary_tube::rise(8, 60);
    CAPTURE(tube.found, tube.exact);
    CHECK(std::abs(tube.found / tube.exact - 1) < 0.15);
}

TEST_CASE("Water fills a slit at Washburn's speed, with the angles of moving lines by Cox", "[fluid]") {
    namespace slit = validation::capillary_filling;
    const double speed = slit::speed(12, 30), still = slit::exact(30), moving = slit::exact(30, slit::slip / 12);
    CAPTURE(speed, still, moving);
    CHECK(std::abs(speed / still - 1) < 0.15);
    CHECK(std::abs(speed / moving - 1) < 0.05);
    CHECK(slit::moving_angle(1, 0.1, 0) == 1);
    const double slow = slit::moving_angle(1, 1e-4, 1) - 1;
    CHECK(slow / (slit::viscosity * 1e-4) ==
          Approx(5.7815).epsilon(1e-3)); // Cox's general f(1) at a viscosity ratio of 1
}

TEST_CASE("A drop dents a soft slab and lifts it at its rim as elasticity says", "[fluid]") {
    const auto found = validation::drop_on_slab::measure(12);
    CAPTURE(found[0].computed, found[1].computed);
    CHECK(std::abs(found[0].error()) < 0.05);
    CHECK(std::abs(found[1].error()) < 0.15);
    CHECK(found[0].reference < 0);
    CHECK(found[1].reference > 0);
}

TEST_CASE("A liquid under a gas of a thousandth of its density stays at rest", "[fluid]") {
    const auto still = validation::still_layers::layers(20, 1);
    CAPTURE(still.pressure, still.speed);
    CHECK(still.pressure < 0.12); // of the particles at the interface, two spacings' weight
    CHECK(still.speed < 0.01);
}

TEST_CASE("A drop swings in a gas of a thousandth of its density", "[fluid]") {
    const auto drop = validation::drop_in_gas::swing(8, 1000);
    CAPTURE(drop.period, drop.pressure);
    CHECK(std::abs(drop.period - 1) < 0.08);
    CHECK(std::abs(drop.pressure - 1) < 0.08);
}

TEST_CASE("Two drops that touch become one, which swings and comes to rest round", "[fluid]") {
    namespace drops = validation::sessile_drop;
    auto scene = drops::drop({6, 4}, 1.0 / 12, {.viscosity = 0.05}, [](const drops::Point& x) {
        return std::hypot(std::abs(x[0] - 3) - 0.7, x[1] - 2) < 0.7;
    });
    const auto length_over_height = [&] {
        const auto x = scene.get<drops::Preset::Water>()[imbibe::position];
        const auto spread = [](const auto& column) { return (column.array() - column.mean()).square().mean(); };
        return std::sqrt(spread(x.col(0)) / spread(x.col(1)));
    };
    CHECK(length_over_height() > 2);
    double least = 9;
    scene.run_until(6, [&](const auto&) { least = std::min(least, length_over_height()); });
    CHECK(least < 0.75); // past the circle
    scene.run_until(12);
    CHECK(std::abs(length_over_height() - 1) < 0.06);
}
