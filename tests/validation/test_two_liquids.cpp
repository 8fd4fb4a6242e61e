// Two liquids that do not mix, beside their references.
#include <cases/validation/capillary_wave.hpp>
#include <cases/validation/drop_in_gas.hpp>
#include <cases/validation/rayleigh_taylor.hpp>
#include <cases/validation/sessile_drop.hpp>

#include <catch_shim.hpp>

#include <cmath>

TEST_CASE("A wave on an interface swings and dies out as Prosperetti's", "[fluid]") {
    const auto exact = validation::capillary_wave::exact(), found = validation::capillary_wave::wave(32);
    CAPTURE(found.period, exact.period, found.trough, exact.trough);
    CHECK(exact.period == Approx(0.605).epsilon(1e-3)); // the roots by another program
    CHECK(exact.trough == Approx(-0.8068).epsilon(1e-3));
    CHECK(std::abs(found.period / exact.period - 1) < 0.07);
    CHECK(std::abs(found.trough / exact.trough - 1) < 0.06);
}

TEST_CASE("A drop in another liquid is under Laplace's pressure and at rest", "[fluid]") {
    const auto drop = validation::sessile_drop::free_drop(16);
    CAPTURE(drop.pressure, drop.speed);
    CHECK(std::abs(drop.pressure - 1) < 0.05);
    CHECK(drop.speed < 0.02);
}

TEST_CASE("A drop on a wall comes to its contact angle", "[fluid]") {
    const double wets = validation::sessile_drop::contact_angle(12, 60),
                 runs_off = validation::sessile_drop::contact_angle(12, 120);
    CAPTURE(wets, runs_off);
    CHECK(std::abs(wets - 60) < 7);
    CHECK(std::abs(runs_off - 120) < 7);
}

TEST_CASE("A heavy liquid sinks into a light one at the rate of theory, under any pressure", "[fluid]") {
    namespace layers = validation::rayleigh_taylor;
    CHECK(layers::exact() == Approx(1.249).epsilon(1e-3));
    for (const double background : {0.0, 10.0}) {
        const double rate = layers::growth(32, background);
        CAPTURE(background, rate);
        CHECK(std::abs(rate / layers::exact() - 1) < 0.05);
    }
}

TEST_CASE("A drop swings in a gas of a hundredth of its density", "[fluid]") {
    const auto drop = validation::drop_in_gas::swing(8, 100);
    CAPTURE(drop.period, drop.pressure);
    CHECK(std::abs(drop.period - 1) < 0.09);
    CHECK(std::abs(drop.pressure - 1) < 0.05);
}
