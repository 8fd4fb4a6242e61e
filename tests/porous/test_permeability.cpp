// Permeability against closed forms: plates, pipes and spheres; and what is refused.
#include <catch_shim.hpp>

#include <imbibe/geometry/combine.hpp>
#include <imbibe/geometry/cylinder.hpp>
#include <imbibe/geometry/sphere.hpp>
#include <imbibe/porous/permeability.hpp>

#include <numbers>

namespace permeability_test {

using namespace imbibe;
using imbibe_test::contains;

namespace {

/// A ball in a cell of side 1.
struct BallInCell {
    Sphere<3> ball;
    bool contains(const Point<3>& x) const { return ball.contains(x) && bounds().contains(x); }
    Box<3> bounds() const { return {{0, 0, 0}, {1, 1, 1}}; }
};

} // namespace

TEST_CASE("Permeability: between plates it is h^3/(12 (h + wall)), across them nothing") {
    // Lengths in spacings of a micrometre.
    const double um = 1e-6;
    const Box<3> cell({0, 0, 0}, {6 * um, 6 * um, 22 * um}), wall({0, 0, 0}, {6 * um, 6 * um, 6 * um});
    const auto found = permeability_of_particles(fill(cell - wall, um), fill(wall, um), cell, um, 0, {.left = 2e-3});
    const double exact = std::pow(16 * um, 3) / 12 / (22 * um);
    CHECK(found.column[0] == Approx(exact).epsilon(0.015));
    CHECK(std::abs(found.column[1]) < 1e-3 * exact);
    CHECK(std::abs(found.column[2]) < 1e-3 * exact);
    CHECK(found.tortuosity == Approx(1).margin(1e-3));
    CHECK(found.porosity == Approx(16.0 / 22));
    CHECK(found.left <= 2e-3);
}

using K = QuinticSpline;
struct Oil : Fluid<LinearState, VolumeContinuity<K>, VolumePressure<K>, MorrisViscosity<K>> {};
struct Pipe : Wall<> {};
template <template <class> class NoSlip>
struct Sticks : Coupling<Oil, Pipe, Into<Pipe, PressureExtrapolation<K>>, VolumePressure<K>,
                         Into<Oil, VolumeContinuity<K>>, Into<Pipe, NoSlip<K>>, NoSlipViscosity<K>> {};

/// Poiseuille flow in a pipe of fitted particles, 12 across: its flux over pi f R^4/(8 mu).
template <template <class> class NoSlip>
double flux_of_pipe() {
    const double R = 6, force = 1e-4;
    const Box<3> cell({-10, -10, 0}, {10, 10, 6});
    const auto body = cell - Cylinder({0, 0, -1}, {0, 0, 1}, R, 8);
    const auto parts = fitted_together(1, cell.lower(), 0, body, cell - body);
    Solver<3, double, SymplecticEuler, Oil, Pipe, Sticks<NoSlip>> scene(
        {.gravity = {0, 0, force}, .support_radius = 3, .periodic_length = {20, 20, 6}});
    const auto oil = scene.add(Oil{{.density = 1, .sound_speed = 3, .viscosity = 1}}, parts[1], 1);
    scene.add(Pipe{{.density = 1}}, parts[0], 1);
    scene.run_until(1.5 * R * R); // exp(-5.78 * 1.5) = 2e-4 is missing
    return scene[oil][velocity].col(2).sum() / 6 / (std::numbers::pi * force * R * R * R * R / 8);
}

TEST_CASE("Permeability: in a pipe of fitted particles the flow is Poiseuille's, nearest with LinearNoSlipVelocity") {
    CHECK(flux_of_pipe<LinearNoSlipVelocity>() == Approx(1.025).margin(0.01));
    CHECK(flux_of_pipe<NoSlipVelocity>() == Approx(1.06).margin(0.015));
}

TEST_CASE("Permeability: spheres of a cubic array, extrapolated from two spacings, are Zick and Homsy's") {
    // Zick and Homsy (1982): k = L^3/(6 pi a K) with K = 7.442 for a solid fraction of 0.216.
    const double a = std::cbrt(3 * 0.216 / (4 * std::numbers::pi));
    const double exact = 1 / (6 * std::numbers::pi * a * 7.442);
    double last = 1;
    int calls = 0;
    PermeabilityRun run;
    run.progress = [&](double left) {
        last = left;
        ++calls;
    };
    const auto found = permeability(BallInCell{Sphere<3>{{0.5, 0.5, 0.5}, a}}, 1.0 / 16, 1, run);
    CHECK(found.column[1] == Approx(exact).epsilon(0.03));
    CHECK(std::abs(found.column[0]) < 0.01 * exact);
    CHECK(found.error > 0.02 * exact);
    CHECK(found.error < 0.1 * exact);
    CHECK(found.tortuosity > 1);
    CHECK(found.tortuosity < 1.1);
    CHECK(calls > 0);
    CHECK(last < run.left);
}

TEST_CASE("Permeability: what cannot be computed is refused") {
    const Box<3> cell({0, 0, 0}, {6, 6, 6}), wall({0, 0, 0}, {6, 6, 3});
    const auto pores = fill(cell - wall, 1.0), body = fill(wall, 1.0);
    CHECK_THROWS_WITH(permeability_of_particles(pores, body, cell, 1, 3), contains("axis = 3"));
    CHECK_THROWS_WITH(permeability_of_particles(pores, body, cell, 0, 0), contains("spacing = 0 m"));
    CHECK_THROWS_WITH(permeability_of_particles({}, body, cell, 1, 0), contains("no particles of liquid"));
    CHECK_THROWS_WITH(permeability_of_particles(pores, {}, cell, 1, 0), contains("nothing resists"));
    CHECK_THROWS_WITH(permeability_of_particles(pores, body, cell, 2, 0), contains("3 spacings long along x"));
    CHECK_THROWS_WITH(permeability_of_particles(pores, body, cell, 1, 0, {.left = 0}), contains("left = 0"));
    const Box<3> wide({0, 0, 0}, {6, 6, 20});
    CHECK_THROWS_WITH(permeability_of_particles(fill(wide - wall, 1.0), body, wide, 1, 0, {.steps = 5}),
                      contains("not steady"));
}

} // namespace permeability_test
