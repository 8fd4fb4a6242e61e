// MorrisViscosity and the no-slip wall: the Laplacian of a velocity, balance across phases, the reflected velocity.
#include "cloud.hpp"

#include <imbibe/fluid/continuity.hpp>
#include <imbibe/kernels/cubic_spline.hpp>
#include <imbibe/wall/no_slip.hpp>

namespace morris_viscosity_test {

using namespace cloud;

namespace {

using Bed = Wall<>;

Water oil() {
    return {.density = 900, .sound_speed = 30, .viscosity = 0.03, .support_radius = 4e-3, .spacing = 1e-3};
}
Water brine() {
    return {.density = 1100, .sound_speed = 30, .viscosity = 0.001, .support_radius = 4e-3, .spacing = 1.1e-3};
}
Bed bed() {
    return {.density = 900, .support_radius = 4e-3, .spacing = 1e-3};
}
Sponge soft() {
    return {.density = 950, .sound_speed = 10, .shear_modulus = 1e4, .support_radius = 4e-3, .spacing = 1e-3};
}

template <int dim>
void check_laplacian() {
    auto fluid = block<dim>(oil(), 9, 0);
    for (auto& p : fluid) {
        ColumnVector<dim> v = ColumnVector<dim>::Zero();
        v[0] = 1e4 * std::pow(plain(p[position])[1] - 4e-3, 2);
        p.set(velocity, vec<dim>(v));
    }
    const auto& centre = fluid[fluid.size() / 2];
    const ColumnVector<dim> force = plain(sum(MorrisViscosity<>{}, centre, fluid));
    CHECK(force[0] == Approx(0.03 / 900 * 2e4).epsilon(0.02));
    CHECK(force.template tail<dim - 1>().norm() < 1e-12 * force.norm());
}

template <int dim>
void check_balance() {
    auto fluid = block<dim>(oil(), 3, 0.2, 1),
         other = block<dim>(brine(), 3, 0.2, 2, ColumnVector<dim>::Constant(5e-4));
    auto wall = block<dim>(soft(), 3, 0.2, 3, ColumnVector<dim>::Constant(4e-4));
    Dice dice(4);
    for (auto* phase : {&fluid, &other})
        for (auto& p : *phase)
            p.set(velocity, dice.vector<dim>(1));
    for (auto& p : wall)
        p.set(no_slip_velocity, dice.vector<dim>(1));
    CHECK(worst_imbalance(MorrisViscosity<>{}, fluid, other) < 1e-14);
    CHECK(worst_imbalance(NoSlipViscosity<>{}, fluid, wall) < 1e-14);
    for (const auto& a : fluid)
        for (const auto& b : fluid)
            REQUIRE((given(MorrisViscosity<>{}, a, b) + given(MorrisViscosity<>{}, b, a)).norm() == 0);
    double power = 0;
    for (const auto& a : fluid)
        power += plain(a[mass]) * plain(a[velocity]).dot(plain(sum(MorrisViscosity<>{}, a, fluid)));
    CHECK(power < 0);
}

template <int dim>
void check_reflection() {
    ColumnVector<dim> below = ColumnVector<dim>::Zero(), U = ColumnVector<dim>::Zero();
    below[1] = -3e-3;
    U[0] = 0.7;
    auto fluid = block<dim>(oil(), 3, 0.2, 1);
    auto wall = block<dim>(bed(), 3, 0.2, 2, below);
    const ColumnVector<dim> moving = ColumnVector<dim>::Constant(0.1);
    for (auto& p : fluid)
        p.set(velocity, vec<dim>(U));
    for (auto& p : wall)
        p.set(velocity, vec<dim>(moving));
    // one that sees no fluid
    ColumnVector<dim> away = ColumnVector<dim>::Constant(-1);
    wall.push_back(block<dim>(bed(), 1, 0, 1, away).front());
    wall.back().set(velocity, vec<dim>(moving));
    for (auto& a : wall) {
        auto total = Vector<Number<double>, dim>::zero();
        Number<double> weight = 0;
        for (const auto& b : fluid) {
            const auto [w, s] = NoSlipVelocity<>::Sum{}(a, b, geometry<NoSlipVelocity<>::Sum, dim>(a, b));
            weight += w;
            total += s;
        }
        a.set(no_slip_weight, weight).set(no_slip_sum, total);
        const ColumnVector<dim> shown = plain(NoSlipVelocity<>::Reflect{}(a));
        const ColumnVector<dim> expected = plain(weight) > 0 ? ColumnVector<dim>(2 * moving - U) : moving;
        CHECK((shown - expected).norm() < 1e-14);
    }
    CHECK(plain(wall.front()[no_slip_weight]) > 0);
    CHECK(plain(wall.back()[no_slip_weight]) == 0);
}

/// What a wall along a lattice shows beside a fluid that is sheared: the straight line through the wall's velocity at
/// the surface.
template <int dim>
void check_straight_line() {
    const Water water = oil();
    ColumnVector<dim> below = ColumnVector<dim>::Zero();
    below[1] = -4 * water.spacing;
    auto fluid = block<dim>(oil(), 7, 0);
    auto wall = block<dim>(bed(), 7, 0, 1, below);
    double surface = 1e9;
    for (const auto& p : fluid)
        surface = std::min(surface, plain(p[position])[1] - 0.5 * water.spacing);
    ColumnVector<dim> middle = ColumnVector<dim>::Zero();
    for (const auto& p : fluid)
        middle += plain(p[position]) / static_cast<double>(fluid.size());
    const auto sheared = [&](double height) {
        ColumnVector<dim> v = ColumnVector<dim>::Constant(0.1); // the wall's own
        v[0] += 50 * (height - surface);
        return v;
    };
    for (auto& p : fluid)
        p.set(velocity, vec<dim>(sheared(plain(p[position])[1])));
    LinearNoSlipVelocity<>::Continue continued;
    continued.prepared =
        LinearNoSlipVelocity<>::prepare(bed(), water, Lattice<dim>{water.spacing, water.support_radius});
    int first = 0, second = 0, alone = 0;
    for (auto& a : wall) {
        a.set(velocity, vec<dim>(ColumnVector<dim>::Constant(0.1)));
        const ColumnVector<dim> x = plain(a[position]);
        const double depth = (surface - x[1]) / water.spacing;
        ColumnVector<dim> aside = x - middle;
        aside[1] = 0;
        if (depth < 0 || aside.cwiseAbs().maxCoeff() > 0.6 * water.spacing)
            continue; // above, or near the ends
        auto total = Vector<Number<double>, dim>::zero(), offset = total;
        Number<double> weight = 0;
        for (const auto& b : fluid) {
            const auto [w, s, o] =
                LinearNoSlipVelocity<>::Sum{}(a, b, geometry<LinearNoSlipVelocity<>::Sum, dim>(a, b));
            weight += w, total += s, offset += o;
        }
        a.set(no_slip_weight, weight).set(no_slip_sum, total).set(no_slip_offset, offset);
        const double shown = plain(continued(a))[0] - 0.1, line = sheared(x[1])[0] - 0.1;
        if (depth < 1) {
            CHECK(shown == Approx(line).epsilon(1e-9));
            ++first;
        } else if (depth < 2) {
            CHECK(shown == Approx(line).epsilon(1e-9));
            ++second;
        } else if (plain(weight) == 0) {
            CHECK(shown == Approx(0).margin(1e-15));
            ++alone;
        }
    }
    CHECK(first > 0);
    CHECK(second > 0);
    CHECK(alone > 0);
}

} // namespace

TEST_CASE("MorrisViscosity is eta/rho times the Laplacian, with the sign that slows") {
    check_laplacian<2>();
    check_laplacian<3>();
}

TEST_CASE("MorrisViscosity and NoSlipViscosity: equal and opposite, and they take energy") {
    check_balance<2>();
    check_balance<3>();
}

TEST_CASE("a wall or a solid shows the viscosity of the fluid it touches, unless it has its own") {
    const Water fluid = oil();
    Bed wall = bed();
    CHECK(imbibe::detail::viscosity_sum(fluid, wall) == 0.06);
    CHECK(imbibe::detail::viscosity_sum(wall, fluid) == 0.06);
    CHECK(imbibe::detail::viscosity_sum(fluid, soft()) == 0.06);
    CHECK(imbibe::detail::viscosity_sum(soft(), fluid) == 0.06);
    CHECK(imbibe::detail::viscosity_sum(fluid, brine()) == Approx(0.031));
    wall.viscosity = 0.01;
    CHECK(imbibe::detail::viscosity_sum(fluid, wall) == Approx(0.04));
    Water inviscid = oil();
    inviscid.viscosity = 0;
    CHECK(imbibe::detail::viscosity_sum(inviscid, brine()) == 0.001);
}

TEST_CASE("NoSlipVelocity reflects the fluid's velocity about the wall's") {
    check_reflection<2>();
    check_reflection<3>();
}

TEST_CASE("LinearNoSlipVelocity continues a sheared fluid in a straight line through the wall's velocity") {
    check_straight_line<2>();
    check_straight_line<3>();
}

TEST_CASE("NoSlipContinuity is VolumeContinuity with the velocity that the wall shows") {
    auto a = block<3>(oil(), 1, 0).front();
    ColumnVector<3> below(0.3e-3, -0.9e-3, 0.2e-3);
    auto shows = block<3>(bed(), 1, 0, 1, below).front(), moves = shows;
    const ColumnVector<3> w(1, -2, 3);
    a.set(velocity, vec<3>(ColumnVector<3>(0.5, 0.1, -0.2)));
    shows.set(velocity, vec<3>(ColumnVector<3>(7, 8, 9))).set(no_slip_velocity, vec<3>(w)).set(volume, 2e-9);
    moves.set(velocity, vec<3>(w)).set(volume, 2e-9);
    using Shown = NoSlipContinuity<>::Sweep;
    using Own = VolumeContinuity<WendlandC2>::Sweep;
    const double rate = plain(Own{}(a, moves, geometry<Own, 3>(a, moves)));
    CHECK(std::abs(rate) > 0);
    CHECK(plain(Shown{}(a, shows, geometry<Shown, 3>(a, shows))) == Approx(rate).epsilon(1e-14));
}

TEST_CASE("the limit of MorrisViscosity is 0.055 H^2/nu, and infinite without viscosity") {
    const TimeStepInput in{4e-3, 1e-3, 1, 1, 3};
    CHECK(MorrisViscosity<>::time_step_limit(oil(), in) == Approx(16e-6 / (1.3 * 14 * 0.03 / 900)).epsilon(1e-4));
    CHECK(MorrisViscosity<>::time_step_limit(oil(), bed(), in) ==
          Approx(16e-6 / (1.3 * 14 * 0.03 / 900)).epsilon(1e-4));
    Water inviscid = oil();
    inviscid.viscosity = 0;
    CHECK(std::isinf(MorrisViscosity<>::time_step_limit(inviscid, in)));
}

TEST_CASE("between two fluids the limit of MorrisViscosity is that of the lighter one with the mean viscosity") {
    const TimeStepInput in{4e-3, 1e-3, 1, 1, 3};
    const double expected = 16e-6 / (1.3 * 14 * 0.5 * (0.03 + 0.001) / 900);
    CHECK(MorrisViscosity<>::time_step_limit(oil(), brine(), in) == Approx(expected).epsilon(1e-4));
    CHECK(MorrisViscosity<>::time_step_limit(brine(), oil(), in) == Approx(expected).epsilon(1e-4));
}

TEST_CASE("the limit of MorrisViscosity is that of its kernel in the dimension of the scene") {
    // S = H^2 times the integral of |grad W|/r. For the cubic spline 2 pi N w(0) with N = 80/(7 pi) and w(0) = 1/2 in
    // the plane, 4 pi N times the integral of w over q, 3/16, with N = 16/pi in space; WendlandC2 has 14 in both.
    for (const auto& [dim, S] : {std::pair{2, 80.0 / 7}, std::pair{3, 12.0}}) {
        const TimeStepInput in{4e-3, 1e-3, 1, 1, dim};
        CHECK(MorrisViscosity<CubicSpline>::time_step_limit(oil(), in) ==
              Approx(16e-6 / (1.3 * S * 0.03 / 900)).epsilon(1e-4));
    }
}

} // namespace morris_viscosity_test
