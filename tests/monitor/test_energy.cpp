// The energies that a phase stores: two ways to describe one solid must agree.
#include "scenes.hpp"

#include <catch_shim.hpp>

#include <imbibe/imbibe.hpp>

namespace energy_test {

namespace {

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Rated : sph::Solid<sph::LinearState, sph::Continuity<K>, sph::VelocityGradient<K>, sph::JaumannStress,
                          sph::StressForce<K>> {};
using monitor_test::Block, monitor_test::BlockScene, monitor_test::Dust, monitor_test::DustScene;

/// What a total-Lagrangian block has stored in the displacement gradient e, J.
template <int dim, class Law, class Energy>
double energy_in(const Eigen::Matrix<double, dim, dim>& e, const Energy& energy) {
    const double dx = 0.1, rho = 950, c = 30, G = 2e5;
    const auto points = sph::fill(sph::Box<dim>(sph::Point<dim>::Zero(), sph::Point<dim>::Constant(0.4)), dx);
    BlockScene<dim, Law> scene({.support_radius = 2 * dx});
    const auto block = scene.add(Block<Law>{{.density = rho, .sound_speed = c, .shear_modulus = G}}, points, dx);
    scene[block][sph::stress_share].setConstant(1);
    auto F = scene[block][sph::deformation_gradient];
    for (int row = 0; row < dim; ++row)
        for (int column = 0; column < dim; ++column)
            F.col(row * dim + column).setConstant((row == column ? 1 : 0) + e(row, column));
    return energy(scene[block]);
}
template <int dim, class Law>
double elastic_energy_in(const Eigen::Matrix<double, dim, dim>& e) {
    return energy_in<dim, Law>(e, [](const auto& block) { return sph::elastic_energy<dim>(block); });
}
template <class Law>
double stored_energy_in(const Eigen::Matrix3d& e) {
    return energy_in<3, Law>(e, [](const auto& block) { return sph::stored_energy(block); });
}

/// The compression and the shear energy of a block with a stress rate in the strain e, and what it has by St. Venant
/// and Kirchhoff, J.
template <int dim>
std::array<double, 3> energies_in(const Eigen::Matrix<double, dim, dim>& e) {
    const double dx = 0.1, rho = 950, c = 30, G = 2e5;
    const auto points = sph::fill(sph::Box<dim>(sph::Point<dim>::Zero(), sph::Point<dim>::Constant(0.4)), dx);

    sph::Solver<dim, double, sph::SymplecticEuler, Rated> rated({.support_radius = 2 * dx});
    const auto a = rated.add(Rated{{.density = rho, .sound_speed = c, .shear_modulus = G}}, points, dx);
    rated[a][sph::density].setConstant(rho / (1 + e.trace()));
    auto S = rated[a][sph::deviatoric_stress];
    for (int row = 0, k = 0; row < dim; ++row)
        for (int column = row; column < dim; ++column, ++k)
            S.col(k).setConstant(2 * G * (e(row, column) - (row == column ? e.trace() / 3 : 0)));
    CHECK(sph::stored_energy(rated[a]) ==
          Approx(sph::compression_energy(rated[a]) + sph::shear_energy<dim>(rated[a])).epsilon(1e-12));

    return {sph::compression_energy(rated[a]), sph::shear_energy<dim>(rated[a]),
            elastic_energy_in<dim, sph::StVenantKirchhoff>(e)};
}

} // namespace

TEST_CASE("A solid with a stress rate stores what a total-Lagrangian one does in a small strain", "[energy]") {
    Eigen::Matrix3d space;
    space << 2, 1, -0.5, 1, -1, 0.7, -0.5, 0.7, 3;
    Eigen::Matrix2d plane;
    plane << 2, 1, 1, -0.5;
    const double small = 1e-5, bulk = 950.0 * 30 * 30, G = 2e5;
    SECTION("in space") {
        const auto [compression, shear, all] = energies_in<3>(small * space);
        const double dev2 = (space - space.trace() / 3 * Eigen::Matrix3d::Identity()).squaredNorm();
        const double volume = 0.4 * 0.4 * 0.4;
        CHECK(shear == Approx(volume * G * dev2 * small * small).epsilon(1e-3));
        CHECK(compression == Approx(volume * bulk / 2 * sph::sq(small * space.trace())).epsilon(1e-3));
        CHECK(compression + shear == Approx(all).epsilon(1e-3));
    }
    SECTION("in the plane") {
        const auto [compression, shear, all] = energies_in<2>(small * plane);
        CHECK(compression == Approx(0.4 * 0.4 * bulk / 2 * sph::sq(small * plane.trace())).epsilon(1e-3));
        CHECK(compression + shear == Approx(all).epsilon(1e-3));
    }
}

TEST_CASE("A total-Lagrangian solid stores what its own law says", "[energy]") {
    const double lambda = 950.0 * 30 * 30 - 2 * 2e5 / 3, mu = 2e5, volume = 0.4 * 0.4 * 0.4, stretch = 0.6;
    Eigen::Matrix3d squeezed = Eigen::Matrix3d::Zero(); // uniaxial, to 0.6 of the length
    squeezed(1, 1) = stretch - 1;
    const double E = (stretch * stretch - 1) / 2, log = std::log(stretch);
    CHECK(elastic_energy_in<3, sph::StVenantKirchhoff>(squeezed) ==
          Approx(volume * (lambda / 2 + mu) * E * E).epsilon(1e-12));
    CHECK(elastic_energy_in<3, sph::CompressibleNeoHookean>(squeezed) ==
          Approx(volume * (lambda / 4 * (2 * E - 2 * log) + mu / 2 * (2 * E - 2 * log))).epsilon(1e-12));
    const double isochoric = volume * (mu / 2 * (std::pow(stretch, -2.0 / 3) * (2 + stretch * stretch) - 3) +
                                       950.0 * 30 * 30 / 4 * (2 * E - 2 * log));
    CHECK(elastic_energy_in<3, sph::IsochoricNeoHookean>(squeezed) == Approx(isochoric).epsilon(1e-12));
    CHECK(stored_energy_in<sph::IsochoricNeoHookean>(squeezed) == Approx(isochoric).epsilon(1e-12));
    // where the volume is the same all around, the mean of it is as well
    CHECK(stored_energy_in<sph::VolumetricDeviatoric<>>(squeezed) == Approx(isochoric).epsilon(1e-12));
}

TEST_CASE("The potential energy of a body is its weight times its height, whichever way gravity points", "[energy]") {
    DustScene<3> scene({.support_radius = 0.2});
    const auto stone = scene.add(Dust{{.density = 800, .sound_speed = 30}}, {{0.3, -0.5, 0.7}}, 0.1);
    for (int d = 0; d < 3; ++d) {
        std::array<double, 3> gravity{};
        gravity[static_cast<std::size_t>(d)] = -9.81;
        const double height = std::array{0.3, -0.5, 0.7}[static_cast<std::size_t>(d)];
        CHECK(sph::potential_energy(scene[stone], gravity) == Approx(0.8 * 9.81 * height));
    }
}

TEST_CASE("What is added during a run stores nothing until it is deformed", "[energy]") {
    const double dx = 0.1;
    const Block<sph::CompressibleNeoHookean> rubber{{.density = 950, .sound_speed = 30, .shear_modulus = 2e5}};
    BlockScene<2, sph::CompressibleNeoHookean> scene({.support_radius = 2 * dx, .time_step = 1e-4});
    const auto block = scene.add(rubber, sph::fill(sph::Box<2>({0, 0}, {1, 1}), dx), dx);
    CHECK(sph::elastic_energy<2>(scene[block]) == 0);
    scene.step();
    scene.add(rubber, sph::fill(sph::Box<2>({5, 0}, {6, 1}), dx), dx);
    CHECK(sph::elastic_energy<2>(scene[block]) == Approx(0).margin(1e-9));
    CHECK(sph::stored_energy(scene[block]) == Approx(0).margin(1e-9));
}

} // namespace energy_test
