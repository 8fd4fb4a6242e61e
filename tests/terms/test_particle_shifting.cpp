// ParticleShifting: still on a lattice and at surfaces, away from where particles are many, within its bound.
#include "cloud.hpp"

#include <imbibe/fluid/particle_shifting.hpp>
#include <imbibe/kernels/cubic_spline.hpp>
#include <imbibe/kernels/quintic_spline.hpp>

#include <eigenvalues.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace particle_shifting_test {

using namespace cloud;

namespace {

using K = WendlandC2;
using Term = ParticleShifting<K>;

Water water_here() {
    return {.density = 1000, .sound_speed = 30, .viscosity = 1e-3, .support_radius = 3e-3, .spacing = 1e-3};
}

template <int dim>
void shift(Cloud<dim, Water>& fluid, const Term::Parameters& with = {}) {
    for (auto& a : fluid) {
        auto gradient = Vector<Number<double>, dim>::zero();
        Number<double> divergence = 0;
        for (const auto& b : fluid) {
            const auto ab = geometry<ShiftingNeighbours<K>, dim>(a, b);
            const auto [g, d] = ShiftingNeighbours<K>{}(a, b, ab);
            gradient += contribution(ab, g);
            divergence += d;
        }
        a.set(concentration_gradient, gradient).set(position_divergence, divergence);
    }
    prepare(Term::Detect{with}, surface_indicator, fluid);
    gather(Term::Approach{}, surface_nearness, fluid, fluid);
    prepare(Term::Shift{with}, transport_correction, fluid);
}

template <int dim>
auto& centre(Cloud<dim, Water>& fluid) {
    return fluid[fluid.size() / 2];
}

template <int dim>
Cloud<dim, Water> stream() {
    auto fluid = block<dim>(water_here(), 9, 0); // five layers from the surface to the centre
    for (auto& p : fluid)
        p.set(velocity, vec<dim>(ColumnVector<dim>::Unit(0) * 2));
    return fluid;
}

template <int dim>
void check_lattice() {
    auto fluid = stream<dim>();
    shift<dim>(fluid);
    for (const auto& p : fluid) {
        const ColumnVector<dim> from_centre = (plain(p[position]) - ColumnVector<dim>::Constant(4e-3)) / 1e-3;
        const double layer = 4 - from_centre.cwiseAbs().maxCoeff(); // 0 at the surface
        const double indicator = plain(p[surface_indicator]);
        if (layer < 0.5)
            CHECK(indicator == 1);
        else if (layer > 1.5)
            CHECK(indicator == 0);
        if (layer < 1.5)
            CHECK(plain(p[transport_correction]).norm() == 0);
        CHECK(plain(p[transport_correction]).norm() < 1e-12);
    }
    CHECK(plain(centre<dim>(fluid)[position_divergence]) == Approx(1).epsilon(0.01));
    CHECK(plain(centre<dim>(fluid)[surface_nearness]) == 0);
}

template <int dim>
void check_direction() {
    auto fluid = stream<dim>();
    const ColumnVector<dim> there = plain(centre<dim>(fluid)[position]);
    const ColumnVector<dim> aside = ColumnVector<dim>::Unit(1) * 2e-5;
    centre<dim>(fluid).set(position, vec<dim>(there + aside));
    shift<dim>(fluid);
    auto& a = centre<dim>(fluid);
    // by hand: - |v| H sum V (1 + 0.2 (W/W(spacing))^4) grad W, far from its bound
    ColumnVector<dim> g = ColumnVector<dim>::Zero();
    const auto w = [](double q) { return q < 1 ? std::pow(1 - q, 4) * (1 + 4 * q) : 0; };
    const double norm = (dim == 2 ? 7 / pi : 21 / (2 * pi)) / std::pow(3e-3, dim + 2);
    for (const auto& b : fluid) {
        const ColumnVector<dim> x = plain(a[position]) - plain(b[position]);
        const double q = x.norm() / 3e-3;
        if (q < 1)
            g += std::pow(1e-3, dim) * (1 + 0.2 * std::pow(w(q) / w(1.0 / 3), 4)) * -20 * norm * std::pow(1 - q, 3) * x;
    }
    const Term::Parameters with{.strength = 1.5};
    const ColumnVector<dim> v = plain(Term::Shift{with}(a)), expected = -2 * 1.5 * 3e-3 * g;
    CHECK((v - expected).norm() < 1e-12 * expected.norm());
    CHECK(v[1] < 0); // back
    CHECK(v.norm() < 0.25 * 2);
    // the bound, and the speed that counts at the least
    CHECK(plain(Term::Shift{{.strength = 1e6}}(a)).norm() == Approx(0.25 * 2));
    a.set(velocity, Vector<Number<double>, dim>::zero());
    CHECK(plain(Term::Shift{with}(a)).norm() == 0);
    CHECK(plain(Term::Shift{{.strength = 1.5, .least_speed = 4}}(a)).norm() == Approx(2 * expected.norm()));
    // no farther in one step than a share of H^3/spacing, however fast
    a.time_step = 1e3;
    CHECK(plain(Term::Shift{{.strength = 1.5, .least_speed = 4}}(a)).norm() * 1e3 ==
          Approx(0.035 * 27e-9 / 1e-3 * g.norm()));
    a.time_step = 1e-9;
    CHECK(plain(Term::Shift{{.strength = 1.5, .least_speed = 4}}(a)).norm() == Approx(2 * expected.norm()));
    // alone
    auto drop = block<dim>(water_here(), 1, 0);
    shift<dim>(drop);
    CHECK(plain(drop.front()[transport_correction]).norm() == 0);
}

/// The most that particles of a square lattice may be shifted in a step, over H^3/spacing times the gradient of
/// concentration, so that no wave of their places overshoots and grows: 2/lambda, with the greatest eigenvalue lambda
/// of how the gradient changes with the places, over waves cos(k.x) of all directions and lengths. (The least is below
/// 0: rows slide past each other until the lattice is a denser one, with any length of steps.)
template <class Kernel>
double bearable_in_a_step(double support) {
    constexpr double dx = 1e-3, little = 1e-4 * dx;
    Water material = water_here();
    material.support_radius = support * dx;
    const auto lattice = block<2>(material, 2 * static_cast<int>(support) + 3, 0);
    const auto& centre = lattice[lattice.size() / 2];
    const auto gradient_in_wave = [&](double kx, double ky, int along) {
        ColumnVector<2> sum = ColumnVector<2>::Zero();
        const auto moved = [&](auto particle) {
            const ColumnVector<2> x = plain(particle[position]), r = (x - plain(centre[position])) / dx;
            particle.set(position,
                         vec<2>(x + ColumnVector<2>::Unit(along) * (little * std::cos(kx * r[0] + ky * r[1]))));
            return particle;
        };
        const auto a = moved(centre);
        for (const auto& b : lattice) {
            const auto other = moved(b);
            const auto ab = geometry<ShiftingNeighbours<Kernel>, 2>(a, other);
            sum += plain(contribution(ab, std::get<0>(ShiftingNeighbours<Kernel>{}(a, other, ab))));
        }
        return ColumnVector<2>(sum / little);
    };
    double stiffest = 0;
    for (int i = 0; i <= 16; ++i)
        for (int j = 0; j <= 16; ++j) {
            Eigen::Matrix2d change;
            for (int along = 0; along < 2; ++along)
                change.col(along) = gradient_in_wave(pi * i / 16, pi * j / 16, along);
            stiffest = std::max(stiffest, imbibe_test::greatest_eigenvalue(0.5 * (change + change.transpose())));
        }
    return 2 / stiffest * dx / std::pow(material.support_radius, 3);
}

} // namespace

TEST_CASE("No wave on a lattice overshoots with what ParticleShiftingParameters says") {
    CHECK(bearable_in_a_step<WendlandC2>(2.6) == Approx(0.038).epsilon(0.02));
    CHECK(bearable_in_a_step<WendlandC2>(3) == Approx(0.042).epsilon(0.02));
    CHECK(bearable_in_a_step<WendlandC2>(4) == Approx(0.042).epsilon(0.02));
    for (const double support : {2.6, 3.0, 3.5, 4.0})
        CHECK(bearable_in_a_step<WendlandC2>(support) > 1.05 * ParticleShiftingParameters{}.most_in_a_step);
    for (const double support : {3.0, 4.0})
        CHECK(bearable_in_a_step<CubicSpline>(support) > 0.049);
    for (const double support : {2.6, 3.0, 4.0}) {
        CAPTURE(support);
        for (const double most :
             {bearable_in_a_step<WendlandC4>(support), bearable_in_a_step<QuinticSpline>(support)}) {
            CHECK(most > 0.019);
            CHECK(most < 0.031);
        }
    }
}
TEST_CASE("ParticleShifting leaves a lattice and free surfaces alone") {
    check_lattice<2>();
    check_lattice<3>();
}
TEST_CASE("ParticleShifting brings a particle back, within its bound") {
    check_direction<2>();
    check_direction<3>();
}
TEST_CASE("ParticleShifting takes a particle for one of the surface by the bounds that it is given") {
    auto a = block<2>(water_here(), 1, 0).front();
    const auto indicator = [&](double divergence, const Term::Parameters& with = {}) {
        a.set(position_divergence, divergence);
        return plain(Term::Detect{with}(a));
    };
    CHECK(indicator(0.8) == Approx(0.5)); // the middle of the ramp from 0.75 to 0.85
    const Term::Parameters wide{.surface_below = 0.5, .inside_above = 0.9};
    CHECK(indicator(0.6, wide) == Approx(0.75));
    CHECK(indicator(0.8, wide) == Approx(0.25));
    CHECK(indicator(0.4, wide) == 1);
    CHECK(indicator(0.95, wide) == 0);
}
TEST_CASE("ParticleShifting checks its coefficients") {
    CHECK_THROWS_AS(ParticleShiftingParameters{.strength = -1}.check("Water"), Error);
    CHECK_THROWS_AS(ParticleShiftingParameters{.most_in_a_step = 0}.check("Water"), Error);
    CHECK_THROWS_AS(ParticleShiftingParameters{.most_in_a_step = std::nan("")}.check("Water"), Error);
    CHECK_THROWS_AS((ParticleShiftingParameters{.surface_below = 0.9, .inside_above = 0.8}.check("Water")), Error);
}

} // namespace particle_shifting_test
