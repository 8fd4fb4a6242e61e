// start_hydrostatic: the density is that of the weight above, volumes stay as they are, and the water stays at rest.
#include "hand.hpp"

#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/monitor/energy.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/hydrostatic.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/state/tait.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

namespace hydrostatic_test {

using namespace imbibe;
using K = WendlandC2;

namespace {

template <class State, class Density>
struct Liquid : Fluid<State, Density, DensityDiffusion<K>, VolumePressure<K>, MonaghanViscosity<K>> {};
struct Bottom : Wall<> {};
template <class Water>
struct On : Coupling<Water, Bottom, Into<Bottom, PressureExtrapolation<K>>, VolumePressure<K>,
                     Into<Water, VolumeContinuity<K>>> {};

constexpr double c = 20, rho = 1000;

/// The density at a depth in closed form: rho (1 + (gamma - 1) g d/c^2)^(1/(gamma - 1)), its limit exp(g d/c^2) at
/// gamma = 1.
template <class State>
double density_at_depth(double g, double depth) {
    if constexpr (std::is_same_v<State, LinearState>)
        return rho * std::exp(g * depth / (c * c));
    else
        return rho * std::pow(1 + 6 * g * depth / (c * c), 1.0 / 6);
}

template <int dim, class Real, class State>
void check_column(const std::array<double, dim>& gravity, const std::array<double, dim>& origin, double tolerance) {
    using Water = Liquid<State, VolumeContinuity<K>>;
    Solver<dim, Real, SymplecticEuler, Water> scene(
        {.gravity = gravity, .support_radius = 0.25, .origin = origin, .threads = 1});
    Point<dim> low = Eigen::Map<const Point<dim>>(origin.data()), up = -Eigen::Map<const Point<dim>>(gravity.data());
    const double g = up.norm();
    up /= g;
    const auto water = scene.add(Water{{.density = rho, .sound_speed = c}},
                                 fill(Box<dim>(low, low + Point<dim>::Constant(1)), 0.1), 0.1);
    const double surface = up.dot(low + Point<dim>::Constant(0.47)); // through the middle of the box, nearly
    for (int twice = 0; twice < 2; ++twice) {                        // the second time nothing changes
        start_hydrostatic(scene, water, surface);
        const auto view = scene[water];
        int wet = 0;
        for (int i = 0; i < view.size(); ++i) {
            const Point<dim> x = view[position].row(i).transpose().template cast<double>();
            const double depth = surface - up.dot(x + low);
            wet += depth > 0;
            const double expected = density_at_depth<State>(g, std::max(depth, 0.0));
            CHECK(static_cast<double>(view[density](i)) == Approx(expected).epsilon(tolerance));
            CHECK(static_cast<double>(view[mass](i) / view[density](i)) == Approx(std::pow(0.1, dim)).epsilon(1e-6));
        }
        CHECK(wet > 0);
        CHECK(wet < view.size());
    }
}

/// Water in a tank, let go: its greatest kinetic energy over rho g depth^2 width, and the least and greatest pressure
/// of its floor over rho g depth.
template <class State, class Density>
void check_rest(bool started) {
    constexpr double dx = 0.05, depth = 0.5, width = 0.5, g = 9.81;
    using Water = Liquid<State, Density>;
    using Scene = Solver<2, double, SymplecticEuler, Water, Bottom, On<Water>>;
    Scene scene({.gravity = {0, -g}, .support_radius = 3 * dx, .periodic_length = {width, 0}, .threads = 1});
    const auto water = scene.add(Water{{.density = rho, .sound_speed = 10 * std::sqrt(2 * g * depth)}},
                                 fill(Box<2>({0, 0}, {width, depth}), dx), dx);
    const auto floor =
        scene.add(Bottom{{.density = rho}}, tank(Box<2>({0, 0}, {width, depth}), dx, 3, Sides::x | Sides::y_high), dx);
    if (started)
        start_hydrostatic(scene, water, depth);
    double least = 1e9, greatest = 0, kinetic = 0;
    scene.run_until(0.3, [&](const Scene& s) {
        if (s.steps() == 0)
            return;
        const auto view = s[floor];
        double sum = 0;
        int number = 0;
        for (int i = 0; i < view.size(); ++i)
            if (view[position](i, 1) > -dx) {
                sum += view[pressure](i);
                ++number;
            }
        least = std::min(least, sum / number / (rho * g * (depth + 0.5 * dx)));
        greatest = std::max(greatest, sum / number / (rho * g * (depth + 0.5 * dx)));
        kinetic = std::max(kinetic, kinetic_energy(s[water]) / (rho * g * depth * depth * width));
    });
    CAPTURE(least, greatest, kinetic);
    CHECK((least > 0.98 && greatest < 1.02) == started);
    CHECK((kinetic < 1e-6) == started);
}

} // namespace

TEST_CASE("an equation of state and its density at a pressure are each other's inverse") {
    const hand::Water water = hand::water();
    for (const double p : {-1e4, 0.0, 1e3, 1e5}) {
        hand::Particle<3, hand::Number<double>> a(water);
        a.set(density, hand::Number<double>(LinearState::density_at(water, p)));
        CHECK(hand::plain(LinearState{}(a)) == Approx(p).epsilon(1e-9).margin(1e-6));
        a.set(density, hand::Number<double>(Tait<>::density_at(water, p)));
        CHECK(hand::plain(Tait<>{}(a)) == Approx(p).epsilon(1e-9).margin(1e-6));
        CHECK(Tait<1>::density_at(water, p) == Approx(LinearState::density_at(water, p)));
    }
}

TEST_CASE("start_hydrostatic gives each particle the density of its depth and keeps its volume") {
    check_column<2, double, LinearState>({0, -9.81}, {0, 0}, 1e-12);
    check_column<2, double, Tait<7>>({0, -9.81}, {3, -7}, 1e-12);
    check_column<2, double, Tait<7>>({3, 4}, {0, 0}, 1e-12);
    check_column<3, double, LinearState>({1, 2, -9}, {-1, 4, 2}, 1e-12);
    check_column<3, float, Tait<7>>({0, 0, -9.81}, {0, 0, 100}, 1e-6);
    check_column<2, double, Tait<7>>({0, -4e3}, {0, 0}, 1e-4); // compressed to 1.4 times its density
}

TEST_CASE("water that starts with the pressure of its weight stays at rest, and other water does not") {
    check_rest<LinearState, VolumeContinuity<K>>(true);
    check_rest<LinearState, VolumeContinuity<K>>(false);
    check_rest<Tait<7>, VolumeContinuity<K>>(true);
    check_rest<Tait<7>, Continuity<K>>(true);
}

TEST_CASE("start_hydrostatic refuses what has no depth") {
    using Water = Liquid<LinearState, VolumeContinuity<K>>;
    using Scene = Solver<2, double, SymplecticEuler, Water>;
    const Water water{{.density = rho, .sound_speed = c}};
    const auto points = fill(Box<2>({0, 0}, {1, 1}), 0.1);
    Scene weightless({.support_radius = 0.3});
    const auto there = weightless.add(water, points, 0.1);
    CHECK_THROWS_WITH(start_hydrostatic(weightless, there, 1), imbibe_test::contains("no gravity"));
    Scene round({.gravity = {0, -9.81}, .support_radius = 0.3, .periodic_length = {0, 1}});
    CHECK_THROWS_WITH(start_hydrostatic(round, round.add(water, points, 0.1), 1),
                      imbibe_test::contains("-9.81 m/s^2 along a periodic side"));
    Scene scene({.gravity = {0, -9.81}, .support_radius = 0.3});
    CHECK_THROWS_WITH(start_hydrostatic(scene, there, 1), imbibe_test::contains("no particles"));
    scene.add(water, points, 0.1);
    CHECK_THROWS_WITH(start_hydrostatic(scene, there, -1), imbibe_test::contains("surface = -1 m"));
    CHECK_THROWS_WITH(start_hydrostatic(scene, there, 500),
                      imbibe_test::contains("a surface at 500 m") && imbibe_test::contains("Is the surface in metres"));
    CHECK_THROWS_WITH(start_hydrostatic(scene, there, std::nan("")), imbibe_test::contains("surface = nan m"));
    CHECK_THROWS_WITH(start_hydrostatic(scene, there, 1, -5), imbibe_test::contains("at_the_surface = -5 Pa"));
    CHECK_NOTHROW(start_hydrostatic(scene, there, 1));
}

TEST_CASE("start_hydrostatic adds the pressure that the surface has") {
    using Water = Liquid<LinearState, VolumeContinuity<K>>;
    Solver<2, double, SymplecticEuler, Water> scene({.gravity = {0, -9.81}, .support_radius = 0.3});
    const auto water = scene.add(Water{{.density = rho, .sound_speed = c}}, fill(Box<2>({0, 0}, {1, 1}), 0.1), 0.1);
    start_hydrostatic(scene, water, 0.6, 500);
    const auto view = scene[water];
    for (int i = 0; i < view.size(); ++i) {
        const double depth = std::max(0.6 - view[position](i, 1), 0.0);
        CHECK(view[density](i) == Approx((rho + 500 / (c * c)) * std::exp(9.81 * depth / (c * c))).epsilon(1e-12));
    }
}

} // namespace hydrostatic_test
