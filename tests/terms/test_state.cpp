// The equations of state against Eq. (8) and their limits of the time step.
#include "hand.hpp"

#include <imbibe/solid/bending_modulus.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/state/tait.hpp>

namespace state_test {

using namespace hand;

namespace {

template <class State, class Real = double>
double pressure_at(double rho) {
    Particle<3, Number<Real>> a(water());
    a.set(density, Number<Real>(rho));
    return plain(State{}(a));
}

double tait_by_hand(double rho, double gamma) {
    return 1000.0 * 30 * 30 / gamma * (std::pow(rho / 1000.0, gamma) - 1);
}

} // namespace

TEST_CASE("Tait is the paper's Eq. (8)") {
    for (const double rho : {900.0, 990.0, 1000.5, 1010.0, 1100.0}) {
        CHECK(pressure_at<Tait<>>(rho) == Approx(tait_by_hand(rho, 7)).epsilon(1e-11));
        CHECK(pressure_at<Tait<1>>(rho) == Approx(tait_by_hand(rho, 1)).epsilon(1e-11));
        CHECK(pressure_at<Tait<4>>(rho) == Approx(tait_by_hand(rho, 4)).epsilon(1e-11));
        CHECK(pressure_at<LinearState>(rho) == Approx(tait_by_hand(rho, 1)).epsilon(1e-11));
    }
    CHECK(pressure_at<Tait<>>(1000) == 0);
    CHECK(pressure_at<LinearState>(1000) == 0);
    Particle<3, Number<double>, Sponge> a(sponge()); // of 950 kg/m^3
    a.set(density, 960.0);
    CHECK(plain(LinearState{}(a)) == Approx(31.6 * 31.6 * 10));
}

TEST_CASE("What no force moves shows the other's speed of sound, what moves its own") {
    const Wall<> wall{.density = 1000};
    CHECK(wall.sound_speed == 1); // which is no sound, but a number that a wall without equation of state has
    CHECK(detail::mean_sound_speed(water(), wall) == 30);
    CHECK(detail::mean_sound_speed(wall, water()) == 30);
    CHECK(detail::mean_sound_speed(water(), sponge()) == Approx(30.8));
    CHECK(std::isinf(mass_weighted_interface_time_step(water(), wall, {H, 8e-4, 0, 0, 3, 5e-4, 0})));
}

TEST_CASE("Tait keeps the digits of float near the reference density") {
    const double rho = 1000.0625; // a float without rounding
    CHECK(relative_error(pressure_at<Tait<>, float>(rho), tait_by_hand(rho, 7)) < 1e-6);
    // (rho/rho0)^7 - 1 in float, for comparison, has lost three digits there
    const float ratio = static_cast<float>(rho) / 1000;
    const double naive = 1000.0 * 900 / 7 * static_cast<double>(power<7>(ratio) - 1);
    CHECK(relative_error(naive, tait_by_hand(rho, 7)) > 1e-5);
}

TEST_CASE("the acoustic limit is 0.6 supports, but a spacing at least, at the fastest wave and the fastest particle") {
    const TimeStepInput in{0.8e-3, 5e-4, 2, 0, 3}, wide{1.3e-3, 5e-4, 2, 0, 3};
    CHECK(Tait<>::time_step_limit(water(), wide) == Approx(0.6 * 1.3e-3 / 32).epsilon(1e-12));
    CHECK(Tait<>::time_step_limit(water(), in) == Approx(5e-4 / 32).epsilon(1e-12));
    CHECK(LinearState::time_step_limit(water(), in) == Approx(5e-4 / 32).epsilon(1e-12));
    const double longitudinal = std::sqrt((950 * 31.6 * 31.6 + 4e6 / 3) / 950);
    CHECK(LinearState::time_step_limit(sponge(), in) == Approx(5e-4 / (longitudinal + 2)).epsilon(1e-12));
    CHECK(longitudinal > 1.5 * 31.6);
    CHECK(std::string_view(Tait<>::limit_name) == "sound");
    CHECK(std::string_view(LinearState::limit_name) == "sound");
}

TEST_CASE("moduli from Young's modulus and Poisson's ratio, and what is none") {
    const double E = 3e6, nu = 0.4, G = shear_modulus_of(E, nu), K = 1100 * sq(sound_speed_of(E, nu, 1100));
    CHECK(9 * K * G / (3 * K + G) == Approx(E));
    CHECK((3 * K - 2 * G) / (6 * K + 2 * G) == Approx(nu));
    CHECK(shear_modulus_of(1, -0.5) == 1);
    static_assert(shear_modulus_of(1, 0) == 0.5); // usable in constants
    using imbibe_test::contains;
    CHECK_THROWS_WITH(sound_speed_of(E, 0.5, 1100),
                      contains("sound_speed_of: Poisson's ratio = 0.5; it must be above -1"));
    CHECK_THROWS_WITH(sound_speed_of(E, 0.6, 1100), contains("Poisson's ratio = 0.6"));
    CHECK_THROWS_WITH(shear_modulus_of(E, -1), contains("shear_modulus_of: Poisson's ratio = -1"));
    CHECK_THROWS_WITH(shear_modulus_of(E, std::nan("")), contains("Poisson's ratio = nan"));
    CHECK_THROWS_WITH(shear_modulus_of(0, 0.3), contains("Young's modulus = 0 Pa"));
    CHECK_THROWS_WITH(sound_speed_of(-E, 0.3, 1100), contains("Young's modulus = -3e+06 Pa"));
    CHECK_THROWS_WITH(sound_speed_of(std::numeric_limits<double>::infinity(), 0.3, 1),
                      contains("Young's modulus = inf"));
    CHECK_THROWS_WITH(sound_speed_of(E, 0.3, 0), contains("density = 0 kg/m^3"));
    CHECK(bending_modulus(E, 2) == Approx(4 * E / 3));
    CHECK_THROWS_WITH(bending_modulus(-1, 2), contains("Young's modulus = -1 Pa"));
}

} // namespace state_test
