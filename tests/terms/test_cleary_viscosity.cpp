// ClearyViscosity: the Laplacian of a velocity, angular momentum, two fluids.
#include "cloud.hpp"

#include <imbibe/fluid/cleary_viscosity.hpp>

namespace cleary_viscosity_test {

using namespace cloud;

namespace {

Water oil() {
    return {.density = 900, .sound_speed = 30, .viscosity = 0.03, .support_radius = 4e-3, .spacing = 1e-3};
}
Water brine() {
    return {.density = 1100, .sound_speed = 30, .viscosity = 0.001, .support_radius = 4e-3, .spacing = 1.1e-3};
}
Sponge soft() {
    return {.density = 950, .sound_speed = 10, .shear_modulus = 1e4, .support_radius = 4e-3, .spacing = 1e-3};
}

/// The force on the particle in the middle of a shear v = 1e4 (n.x)^2 along t, in terms of the exact one.
template <int dim>
double shear(const ColumnVector<dim>& t, const ColumnVector<dim>& n) {
    auto fluid = block<dim>(oil(), 9, 0);
    for (auto& p : fluid)
        p.set(velocity, vec<dim>(1e4 * std::pow(n.dot(plain(p[position]) - ColumnVector<dim>::Constant(4e-3)), 2) * t));
    const ColumnVector<dim> force = plain(sum(ClearyViscosity<>{}, fluid[fluid.size() / 2], fluid));
    CHECK((force - t.dot(force) * t).norm() < 1e-12 * force.norm());
    return t.dot(force) / (0.03 / 900 * 2e4);
}

// On a lattice the sum depends on the direction: too little along its axes, too much along its diagonals.
template <int dim>
void check_laplacian() {
    ColumnVector<dim> x = ColumnVector<dim>::Unit(0), y = ColumnVector<dim>::Unit(1);
    const double along_axis = shear<dim>(x, y);
    const double along_diagonal = shear<dim>((x + y).normalized(), (x - y).normalized());
    CAPTURE(along_axis, along_diagonal);
    CHECK(along_axis == Approx(1).epsilon(0.045));
    CHECK(along_diagonal == Approx(1).epsilon(0.045));
    CHECK(0.5 * (along_axis + along_diagonal) == Approx(1).epsilon(0.005));
}

template <int dim>
void check_by_hand() {
    const auto a = block<dim>(oil(), 1, 0.2, 1).front();
    auto b = block<dim>(brine(), 1, 0.2, 2, ColumnVector<dim>::Constant(1e-3)).front();
    ColumnVector<dim> v = ColumnVector<dim>::Constant(0.3);
    v[0] = -0.8;
    b.set(velocity, vec<dim>(v)).set(density, 1090.0);
    const ColumnVector<dim> x = plain(a[position]) - plain(b[position]);
    const double r = x.norm(), q = r / 4e-3, eta = 2 * 0.03 * 0.001 / 0.031;
    const double F = -20 * (dim == 2 ? 7 / pi : 21 / (2 * pi)) / std::pow(4e-3, dim + 2) * std::pow(1 - q, 3);
    const ColumnVector<dim> expected =
        2 * (dim + 2) * eta * plain(b[mass]) / (900 * 1090.0) * (-v).dot(x) / (r * r) * F * x;
    const ColumnVector<dim> force = plain(sum(ClearyViscosity<>{}, a, std::vector{b}));
    CHECK((force - expected).norm() < 1e-12 * expected.norm());
}

template <int dim>
void check_conservation() {
    auto fluid = block<dim>(oil(), 3, 0.2, 1),
         other = block<dim>(brine(), 3, 0.2, 2, ColumnVector<dim>::Constant(5e-4));
    auto solid = block<dim>(soft(), 3, 0.2, 3, ColumnVector<dim>::Constant(4e-4));
    Dice dice(4);
    for (auto* phase : {&fluid, &other})
        for (auto& p : *phase)
            p.set(velocity, dice.vector<dim>(1));
    for (auto& p : solid)
        p.set(velocity, dice.vector<dim>(1));
    CHECK(worst_imbalance(ClearyViscosity<>{}, fluid, other) < 1e-14);
    CHECK(worst_imbalance(ClearyViscosity<>{}, fluid, solid) < 1e-14);
    double power = 0, torque = 0, size = 0;
    for (const auto& a : fluid) {
        const ColumnVector<dim> x = plain(a[position]);
        const ColumnVector<dim> f = plain(a[mass]) * plain(sum(ClearyViscosity<>{}, a, fluid));
        power += plain(a[velocity]).dot(f);
        torque += x[0] * f[1] - x[1] * f[0];
        size += x.norm() * f.norm();
    }
    CHECK(power < 0);
    CHECK(std::abs(torque) < 1e-14 * size);
}

} // namespace

TEST_CASE("ClearyViscosity is eta/rho times the Laplacian, with the sign that slows") {
    check_laplacian<2>();
    check_laplacian<3>();
}
TEST_CASE("ClearyViscosity is its equation, with the harmonic mean of the viscosities") {
    check_by_hand<2>();
    check_by_hand<3>();
    CHECK(imbibe::detail::harmonic_viscosity(oil(), soft()) == 0.03);
    CHECK(imbibe::detail::harmonic_viscosity(soft(), oil()) == 0.03);
    Water inviscid = oil();
    inviscid.viscosity = 0;
    CHECK(imbibe::detail::harmonic_viscosity(inviscid, oil()) == 0);
    CHECK(imbibe::detail::harmonic_viscosity(inviscid, inviscid) == 0);
}
TEST_CASE("ClearyViscosity keeps momentum and angular momentum, and takes energy") {
    check_conservation<2>();
    check_conservation<3>();
}
TEST_CASE("the limit of ClearyViscosity is dim/(dim + 2) of that of MorrisViscosity, and less along a wave") {
    for (const int dim : {2, 3}) {
        const TimeStepInput in{4e-3, 1e-3, 1, 1, dim};
        CHECK(ClearyViscosity<>::time_step_limit(oil(), in) ==
              Approx(MorrisViscosity<>::time_step_limit(oil(), in) * dim / (dim + 2) / (dim == 2 ? 1.4 : 1.6)));
        // between two fluids that of one with the harmonic mean of the viscosities and the lighter density
        Water both = oil();
        both.viscosity = 2 * 0.03 * 0.001 / (0.03 + 0.001);
        const double expected = ClearyViscosity<>::time_step_limit(both, in);
        CHECK(ClearyViscosity<>::time_step_limit(oil(), brine(), in) == Approx(expected));
        CHECK(ClearyViscosity<>::time_step_limit(brine(), oil(), in) == Approx(expected));
    }
}

} // namespace cleary_viscosity_test
