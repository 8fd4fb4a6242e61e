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

TEST_CASE("Permeability: in a pipe of fitted particles it is pi r^4/8 over the cell's area") {
    const double R = 6, side = 20;
    const Box<3> cell({-side / 2, -side / 2, 0}, {side / 2, side / 2, 6});
    const auto body = cell - Cylinder({0, 0, -1}, {0, 0, 1}, R, 8);
    const double exact = std::numbers::pi * R * R * R * R / 8 / (side * side);
    const auto parts = fitted_together(1, cell.lower(), 0, body, cell - body);
    const auto found = permeability_of_particles(parts[1], parts[0], cell, 1, 2, {.left = 2e-3});
    CHECK(found.column[2] == Approx(exact).epsilon(0.04)); // 2.5 % too much
    CHECK(found.column[2] > exact);
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
    CHECK(found.error > 0.05 * exact); // the pressure in walls is of first order
    CHECK(found.error < 0.2 * exact);
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
