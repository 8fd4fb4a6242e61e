// Elastic moduli of porous cells against closed forms, a finite squeeze, and what is refused.
#include <catch_shim.hpp>

#include <imbibe/geometry/cylinder.hpp>
#include <imbibe/geometry/particle_image.hpp>
#include <imbibe/geometry/triply_periodic.hpp>
#include <imbibe/porous/elastic_moduli.hpp>
#include <imbibe/porous/permeability.hpp>

#include <numbers>

namespace elastic_moduli_test {

using namespace imbibe;
using imbibe_test::contains;

namespace {

Eigen::Matrix3d along(int axis, double strain) {
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
    gradient(axis, axis) = strain;
    return gradient;
}

} // namespace

TEST_CASE("Elastic moduli: a cell without pores has those of its material") {
    const Box<3> cell({1, 2, 3}, {9, 10, 11});
    const auto body = fill(cell, 1.0);
    const double nu = 0.3, lambda = nu / (1 + nu) / (1 - 2 * nu), mu = 1 / (2 * (1 + nu));

    const auto small = strained(body, cell, 1, along(0, 1e-4));
    CHECK(small.stress(0, 0) == Approx(1e-4 * (lambda + 2 * mu)).epsilon(1e-3));
    CHECK(small.stress(1, 1) == Approx(1e-4 * lambda).epsilon(1e-3));

    // CompressibleNeoHookean: P = mu (F - 1/F) + lambda/2 (J^2 - 1)/F.
    const auto squeezed = strained(body, cell, 1, along(2, -0.3));
    CHECK(squeezed.stress(2, 2) == Approx(mu * (0.7 - 1 / 0.7) + lambda / 2 * (0.49 - 1) / 0.7).epsilon(1e-6));
    double worst = 0; // each is where it belongs, in the order that it had
    for (std::size_t i = 0; i < body.size(); ++i) {
        const Point<3> x = body[i] - cell.lower();
        worst = std::max(worst, (squeezed.body[i] - cell.lower() - Point<3>(x[0], x[1], 0.7 * x[2])).norm());
    }
    CHECK(worst < 1e-9);
}

TEST_CASE("Elastic moduli: plates bear along themselves as plates do, and not across") {
    const Box<3> cell({0, 0, 0}, {6, 6, 18});
    const auto body = fill(Box<3>({0, 0, 0}, {6, 6, 12}), 1.0);
    const auto pulled = strained(body, cell, 1, along(0, 1e-4), {.support = 1.5});
    CHECK(pulled.stress(0, 0) == Approx(1e-4 * 12.0 / 18 / (1 - 0.09)).epsilon(0.02));
    CHECK(std::abs(pulled.stress(2, 2)) < 1e-3 * pulled.stress(0, 0));
    const auto apart = strained(body, cell, 1, along(2, 1e-4), {.support = 1.5});
    CHECK(std::abs(apart.stress(2, 2)) < 1e-7);
    CHECK(apart.steps < 2000);
}

TEST_CASE("Elastic moduli: a block with long holes is as stiff along them as what is left of it") {
    const Box<3> cell({0, 0, 0}, {1, 1, 0.25});
    const double radius = std::sqrt(0.3 / std::numbers::pi);
    const auto found = elastic_moduli(cell - Cylinder({0.5, 0.5, -1}, {0, 0, 1}, radius, 3), 1.0 / 24);
    CHECK(found.porosity == Approx(0.3).margin(0.005));
    CHECK(found.young(2) == Approx(0.7).epsilon(0.02));
    CHECK(found.poisson(2, 0) == Approx(0.3).epsilon(0.03));
    CHECK(found.young(0) == Approx(found.young(1)).epsilon(0.005));
    CHECK(found.young(0) < 0.8 * found.young(2));
    CHECK(found.shear(2) < found.shear(0)); // across the holes
    CHECK((found.stiffness - found.stiffness.transpose()).norm() < 2e-3 * found.stiffness.norm());
    CHECK(found.error(2, 2) > 0);
    CHECK(found.error(2, 2) < 0.2 * found.stiffness(2, 2));
}

TEST_CASE("A gyroid that is squeezed lets less through") {
    const auto gyroid_cell = gyroid({{0, 0, 0}, {1, 1, 1}}, 1, 0.3);
    const double dx = 1.0 / 16;
    const Box<3> cell = gyroid_cell.bounds();
    const auto body = fitted_together(dx, cell.lower(), 0, gyroid_cell, cell - gyroid_cell)[0];
    const auto squeezed = strained(body, cell, dx, along(2, -0.25), {.left = 1e-2});
    CHECK(squeezed.stress(2, 2) < -0.005);
    const Box<3> lower({0, 0, 0}, {1, 1, 0.75});
    const auto before = permeability(gyroid_cell, dx, 2);
    const auto packed_anew = permeability(body_of_particles(body, cell, dx), dx, 2);
    const auto after = permeability(body_of_particles(squeezed.body, lower, dx), dx, 2);
    CHECK(packed_anew.column[2] == Approx(before.column[2]).epsilon(0.1));
    CHECK(after.porosity == Approx(1 - (1 - before.porosity) / 0.75).margin(0.01));
    CHECK(after.column[2] < 0.7 * before.column[2]);
    CHECK(after.column[2] > 0.2 * before.column[2]);
}

TEST_CASE("Elastic moduli: what cannot be computed is refused") {
    const Box<3> cell({0, 0, 0}, {6, 6, 6});
    const auto body = fill(cell, 1.0);
    CHECK_THROWS_WITH(strained({}, cell, 1, along(0, 0.1)), contains("no particles"));
    CHECK_THROWS_WITH(strained(body, cell, 0, along(0, 0.1)), contains("spacing = 0 m"));
    CHECK_THROWS_WITH(strained(body, cell, 1, along(0, -0.9)), contains("principal stretch below 0.2"));
    CHECK_THROWS_WITH(strained(body, cell, 1, along(0, std::nan(""))), contains("not finite"));
    CHECK_THROWS_WITH(strained(body, cell, 1, along(0, 0.1), {.poisson_ratio = 0.5}), contains("from 0 to 0.45"));
    CHECK_THROWS_WITH(strained(body, cell, 1, along(0, 0.1), {.support = 4}), contains("from 1.5 to 3"));
    CHECK_THROWS_WITH(strained(body, cell, 1, along(0, 0.1), {.left = 0}), contains("from 1e-6 to 0.1"));
    CHECK_THROWS_WITH(strained(fill(Box<3>({0, 0, 0}, {6, 6, 3}), 1.0), cell, 1, along(0, 0.1), {.steps = 5}),
                      contains("not at rest"));
    CHECK_THROWS_WITH(elastic_moduli(cell - Box<3>({0, 0, 0}, {2, 2, 2}), 0.7), contains("whole number"));
}

} // namespace elastic_moduli_test
