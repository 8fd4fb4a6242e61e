// The two neo-Hookean laws: energies, uniaxial stretch and shear in closed form, small strains, plane strain, and how
// far the two are apart.
#include "cloud.hpp"

#include <imbibe/solid/neo_hookean.hpp>

#include <Eigen/Dense>

namespace neo_hookean_test {

using namespace cloud;

namespace {

Sponge rubber(double poisson) {
    const double young = 1e5, rho = 950;
    return {.density = rho,
            .sound_speed = sound_speed_of(young, poisson, rho),
            .shear_modulus = shear_modulus_of(young, poisson),
            .support_radius = 2.6e-3,
            .spacing = 1e-3};
}
template <class Law, int dim>
Matrix<dim> stress_of(const Sponge& material, const Matrix<dim>& F) {
    auto p = block<dim>(material, 1, 0).front();
    p.set(deformation_gradient, tensor<dim>(F));
    return plain(Law{}(p));
}
/// P F^T/J: the true stress, Pa.
template <class Law, int dim>
Matrix<dim> true_stress_of(const Sponge& material, const Matrix<dim>& F) {
    return stress_of<Law, dim>(material, F) * F.transpose() / F.determinant();
}
template <class Law, int dim>
double energy_of(const Sponge& material, const Matrix<dim>& F) {
    imbibe::Tensor<double, dim> components;
    for (int k = 0; k < components.size; ++k)
        components[k] = F(k / dim, k % dim);
    return Law::stored_energy(material, components);
}
/// The energy as the header prints it, of the deformation in space.
template <class Law>
double energy_by_hand(const Sponge& material, const Matrix<3>& F) {
    const double K = material.bulk_modulus(), G = material.shear_modulus, lambda = K - 2 * G / 3;
    const double J = F.determinant(), C = F.squaredNorm(), volume = J * J - 1 - 2 * std::log(J);
    if constexpr (std::is_same_v<Law, CompressibleNeoHookean>)
        return G / 2 * (C - 3 - 2 * std::log(J)) + lambda / 4 * volume;
    else
        return G / 2 * (std::pow(J, -2.0 / 3) * C - 3) + K / 4 * volume;
}
Matrix<3> in_space(const Matrix<2>& F) {
    Matrix<3> all = Matrix<3>::Identity();
    all.topLeftCorner<2, 2>() = F;
    return all;
}
template <int dim>
Matrix<dim> stretched(double stretch) {
    Matrix<dim> F = Matrix<dim>::Identity();
    F(0, 0) = stretch;
    return F;
}
/// P_11 of a stretch along x that is held sideways, in closed form.
template <class Law>
double held_sideways(const Sponge& material, double x) {
    const double K = material.bulk_modulus(), G = material.shear_modulus, lambda = K - 2 * G / 3;
    if constexpr (std::is_same_v<Law, CompressibleNeoHookean>)
        return G * (x - 1 / x) + lambda / 2 * (x - 1 / x);
    else
        return G * 2 / 3 * std::pow(x, -5.0 / 3) * (x * x - 1) + K / 2 * (x - 1 / x);
}

template <class Law>
void check_energy_and_slope() {
    const Sponge material = rubber(0.3);
    Dice dice(4);
    for (int k = 0; k < 20; ++k) {
        Matrix<3> F = Matrix<3>::Identity();
        do
            for (int i = 0; i < 9; ++i)
                F(i / 3, i % 3) = (i % 4 == 0) + dice(-0.6, 0.6);
        while (F.determinant() < 0.3);
        CHECK(energy_of<Law, 3>(material, F) == Approx(energy_by_hand<Law>(material, F)).epsilon(1e-12));
        const Matrix<3> P = stress_of<Law, 3>(material, F);
        for (int i = 0; i < 9; ++i) {
            Matrix<3> up = F, down = F;
            up(i / 3, i % 3) += 1e-5, down(i / 3, i % 3) -= 1e-5;
            const double slope = (energy_by_hand<Law>(material, up) - energy_by_hand<Law>(material, down)) / 2e-5;
            CHECK(P(i / 3, i % 3) == Approx(slope).epsilon(1e-6).margin(1e-6 * material.shear_modulus));
        }
    }
}

template <class Law>
void check_plane_is_space_with_a_third_stretch_of_one() {
    const Sponge material = rubber(0.3);
    Matrix<2> F;
    F << 1.3, 0.4, -0.2, 0.7;
    const Matrix<3> P = stress_of<Law, 3>(material, in_space(F));
    CHECK((stress_of<Law, 2>(material, F) - P.topLeftCorner<2, 2>()).norm() < 1e-12 * P.norm());
    CHECK(std::abs(P(2, 2)) > 0.01 * P.norm()); // it is held there
    CHECK(energy_of<Law, 2>(material, F) == Approx(energy_by_hand<Law>(material, in_space(F))).epsilon(1e-12));
}

template <class Law, int dim>
void check_held_sideways() {
    for (const double poisson : {0.0, 0.3, 0.45})
        for (const double stretch : {0.3, 0.8, 1.0, 1.5, 2.5}) {
            const Sponge material = rubber(poisson);
            const Matrix<dim> P = stress_of<Law, dim>(material, stretched<dim>(stretch));
            CAPTURE(dim, poisson, stretch);
            CHECK(P(0, 0) ==
                  Approx(held_sideways<Law>(material, stretch)).epsilon(1e-12).margin(1e-11 * material.shear_modulus));
            CHECK(std::abs(P(0, 1)) + std::abs(P(1, 0)) == 0);
        }
}

/// Pulled along x and free sideways, in space: the cross-section that makes P_22 vanish, found by halving.
template <class Law>
double free_sideways(const Sponge& material, double stretch) {
    Matrix<3> F = stretched<3>(stretch);
    double less = 0.2, more = 5;
    for (int k = 0; k < 100; ++k) {
        F(1, 1) = F(2, 2) = 0.5 * (less + more);
        (stress_of<Law, 3>(material, F)(1, 1) < 0 ? less : more) = F(1, 1);
    }
    return stress_of<Law, 3>(material, F)(0, 0);
}

template <class Law, int dim>
void check_small_strains() {
    for (const double poisson : {0.0, 0.3, 0.45}) {
        const Sponge material = rubber(poisson);
        const double lambda = material.bulk_modulus() - 2 * material.shear_modulus / 3;
        Dice dice(7);
        Matrix<dim> slope;
        for (int i = 0; i < dim * dim; ++i)
            slope(i / dim, i % dim) = 1e-7 * dice(-1, 1);
        const Matrix<dim> strain = 0.5 * (slope + slope.transpose());
        const Matrix<dim> hooke =
            lambda * strain.trace() * Matrix<dim>::Identity() + 2 * material.shear_modulus * strain;
        CAPTURE(dim, poisson);
        CHECK(relative_error(stress_of<Law, dim>(material, Matrix<dim>::Identity() + slope), hooke) < 1e-5);
        CHECK(energy_of<Law, dim>(material, Matrix<dim>::Identity()) == Approx(0).margin(1e-10));
        const Matrix<dim> larger = Matrix<dim>::Identity() + 1e3 * slope;
        const double stored =
            0.5e6 * (lambda * std::pow(strain.trace(), 2) + 2 * material.shear_modulus * strain.squaredNorm());
        CHECK(energy_of<Law, dim>(material, larger) == Approx(stored).epsilon(2e-3));
    }
}

template <class Law>
void check_inside_out() {
    Matrix<2> inverted = Matrix<2>::Identity();
    inverted(0, 0) = -0.1;
    CHECK(stress_of<Law, 2>(rubber(0.3), inverted)(0, 0) < -1e6);
}

} // namespace

TEST_CASE("the neo-Hookean laws are derivatives of the energies that their header prints") {
    check_energy_and_slope<CompressibleNeoHookean>();
    check_energy_and_slope<IsochoricNeoHookean>();
}

TEST_CASE("the neo-Hookean laws in the plane are those in space with a third stretch of one") {
    check_plane_is_space_with_a_third_stretch_of_one<CompressibleNeoHookean>();
    check_plane_is_space_with_a_third_stretch_of_one<IsochoricNeoHookean>();
}

TEST_CASE("the neo-Hookean laws stretched along one axis, in closed form") {
    check_held_sideways<CompressibleNeoHookean, 2>();
    check_held_sideways<CompressibleNeoHookean, 3>();
    check_held_sideways<IsochoricNeoHookean, 2>();
    check_held_sideways<IsochoricNeoHookean, 3>();
    // Free sideways and hardly compressible both are the rubber of textbooks, P = G (x - 1/x^2).
    const Sponge material = rubber(0.49999);
    for (const double stretch : {0.5, 0.8, 1.5, 2.0}) {
        const double incompressible = material.shear_modulus * (stretch - 1 / (stretch * stretch));
        CAPTURE(stretch);
        CHECK(free_sideways<CompressibleNeoHookean>(material, stretch) == Approx(incompressible).epsilon(1e-4));
        CHECK(free_sideways<IsochoricNeoHookean>(material, stretch) == Approx(incompressible).epsilon(1e-4));
    }
}

TEST_CASE("the neo-Hookean laws are apart by as much as their comment says") {
    const auto excess = [](double poisson, double stretch) {
        const Sponge material = rubber(poisson);
        const Matrix<3> F = stretched<3>(stretch);
        return stress_of<CompressibleNeoHookean, 3>(material, F)(0, 0) /
                   stress_of<IsochoricNeoHookean, 3>(material, F)(0, 0) -
               1;
    };
    CHECK(excess(0.3, 0.8) == Approx(-0.058).margin(5e-4));
    CHECK(excess(0.3, 1.5) == Approx(0.099).margin(5e-4));
    CHECK(excess(0.45, 0.8) == Approx(-0.019).margin(5e-4));
    CHECK(excess(0.45, 1.5) == Approx(0.030).margin(5e-4));
}

TEST_CASE("the neo-Hookean laws are Hooke's for small strains, and push back when turned inside out") {
    check_small_strains<CompressibleNeoHookean, 2>();
    check_small_strains<CompressibleNeoHookean, 3>();
    check_small_strains<IsochoricNeoHookean, 2>();
    check_small_strains<IsochoricNeoHookean, 3>();
    check_inside_out<CompressibleNeoHookean>();
    check_inside_out<IsochoricNeoHookean>();
}

TEST_CASE("the neo-Hookean laws in simple shear: the modulus times the shear, however far, and what it pulls along") {
    const Sponge material = rubber(0.3);
    const double G = material.shear_modulus;
    for (const double shear : {0.1, 0.5, 1.0, 1.57, 3.0}) {
        Matrix<2> F = Matrix<2>::Identity();
        F(0, 1) = shear;
        CAPTURE(shear);
        const Matrix<2> compressible = true_stress_of<CompressibleNeoHookean, 2>(material, F);
        CHECK(compressible(0, 1) == Approx(G * shear).epsilon(1e-12));
        CHECK(compressible(0, 0) == Approx(G * shear * shear).epsilon(1e-12)); // it also pulls along (Poynting)
        CHECK(std::abs(compressible(1, 1)) < 1e-9);
        const Matrix<2> isochoric = true_stress_of<IsochoricNeoHookean, 2>(material, F);
        CHECK(isochoric(0, 1) == Approx(G * shear).epsilon(1e-12));
        CHECK(isochoric(0, 0) == Approx(G * shear * shear * 2 / 3).epsilon(1e-12)); // without a mean stress
        CHECK(isochoric(1, 1) == Approx(-G * shear * shear / 3).epsilon(1e-12));
    }
}

TEST_CASE("IsochoricNeoHookean: the volume alone makes the mean stress, and it alone") {
    const Sponge material = rubber(0.3);
    Dice dice(3);
    for (const double J : {0.5, 1.0, 1.7})
        for (int k = 0; k < 5; ++k) {
            Matrix<3> F = Matrix<3>::Identity();
            for (int i = 0; i < 9; ++i)
                F(i / 3, i % 3) += dice(-0.3, 0.3);
            F *= std::cbrt(J / F.determinant());
            const Matrix<3> sigma = true_stress_of<IsochoricNeoHookean, 3>(material, F);
            CHECK(sigma.trace() / 3 == Approx(material.bulk_modulus() / 2 * (J - 1 / J)).epsilon(1e-12).margin(1e-7));
        }
    const Matrix<3> squeezed = true_stress_of<IsochoricNeoHookean, 3>(material, 0.8 * Matrix<3>::Identity());
    CHECK((squeezed - squeezed.trace() / 3 * Matrix<3>::Identity()).norm() < 1e-12 * squeezed.norm());
}

} // namespace neo_hookean_test
