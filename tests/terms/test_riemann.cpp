// The Riemann scheme inside a fluid and at a wall: against the equations written out by hand, what it dissipates, and
// what it must leave alone.
#include "cloud.hpp"

#include <imbibe/wall/riemann_wall.hpp>

namespace riemann_test {

using namespace cloud;

namespace {

using K = WendlandC2;
using Bed = Wall<>;

Water brine() {
    return {.density = 1100, .sound_speed = 30, .viscosity = 1e-3, .support_radius = 3e-3, .spacing = 1e-3};
}
Water oil() {
    return {.density = 800, .sound_speed = 20, .viscosity = 1e-3, .support_radius = 3e-3, .spacing = 1e-3};
}
Sponge soft() {
    return {.density = 950, .sound_speed = 10, .shear_modulus = 1e4, .support_radius = 3e-3, .spacing = 1e-3};
}
Bed bed() {
    return {.density = 1100, .support_radius = 3e-3, .spacing = 1e-3};
}

/// F with grad W = F x, by hand.
template <int dim>
double gradient_factor(double r, double H) {
    const double q = r / H, norm = dim == 2 ? 7 / pi : 21 / (2 * pi);
    return q < 1 ? -20 * norm / std::pow(H, dim + 2) * std::pow(1 - q, 3) : 0;
}

/// A block with random velocities and densities, and with the pressure that belongs to them.
template <int dim>
Cloud<dim, Water> moving(const Water& fluid, int n, unsigned seed, double speed = 1, double shift = 0) {
    auto all = block<dim>(fluid, n, 0.2, seed, ColumnVector<dim>::Constant(shift));
    Dice dice(seed + 10);
    for (auto& p : all) {
        const double rho = fluid.density * dice(0.98, 1.02);
        p.set(velocity, dice.vector<dim>(speed)).set(density, rho);
        p.set(pressure, fluid.sound_speed * fluid.sound_speed * (rho - fluid.density));
        p.set(volume, p[mass] / p[density]).set(pressure_over_impedance, RiemannPressure<K>::Prepare{}(p));
        p.set(supported_share, dice(-0.5, 1.5));
    }
    return all;
}

struct Waves { // between the two sides of a pair
    double p, U_a, U_b, speed, distance, F, V_a, V_b;
};

template <int dim, class A, class B>
Waves by_hand(const A& a, const B& b, double eta, const ColumnVector<dim>& g) {
    const ColumnVector<dim> x = plain(a[position]) - plain(b[position]);
    const double r = x.norm();
    const ColumnVector<dim> e = -x / r;
    const double Z_a = a.material.density * a.material.sound_speed, Z_b = b.material.density * b.material.sound_speed;
    const double p_a = plain(a[pressure]), p_b = plain(b[pressure]), c_a = a.material.sound_speed,
                 c_b = b.material.sound_speed;
    const double U_a = e.dot(plain(a[velocity])), U_b = e.dot(plain(b[velocity]));
    const double beta = std::min(eta * std::max(U_a - U_b, 0.0) / (0.5 * (c_a + c_b)), 1.0);
    const double rest =
        0.5 * (plain(a[density] * a[supported_share]) + plain(b[density] * b[supported_share])) * g.dot(x);
    return {(Z_b * p_a + Z_a * p_b + beta * Z_a * Z_b * (U_a - U_b)) / (Z_a + Z_b),
            U_a,
            U_b,
            (Z_a * U_a + Z_b * U_b + p_a - p_b - rest) / (Z_a + Z_b),
            r,
            gradient_factor<dim>(r, a.material.support_radius),
            plain(a[mass]) / plain(a[density]),
            plain(b[mass]) / plain(b[density])};
}

template <int dim>
void check_equations(const Water& first, const Water& second) {
    const auto all = moving<dim>(first, 3, 1, 8), others = moving<dim>(second, 3, 2, 8, 4e-4);
    ColumnVector<dim> g = ColumnVector<dim>::Constant(2);
    g[dim - 1] = -9.81;
    const RiemannPressure<K>::Push push{};
    const RiemannContinuity<K> rate{};
    int approaching = 0, saturated = 0;
    for (const auto& a : all)
        for (const auto& b : others) {
            const auto ab = geometry<RiemannContinuity<K>, dim>(a, b, g);
            const auto w = by_hand<dim>(a, b, 3, g);
            const ColumnVector<dim> x = plain(a[position]) - plain(b[position]);
            const ColumnVector<dim> force = -2 / plain(a[mass]) * w.V_a * w.V_b * w.p * w.F * x;
            CHECK((plain(contribution(ab, push(a, b, ab))) - force).norm() <= 1e-12 * force.norm());
            // (v_a - v*).grad W is the part along e, (U_a - U*) e.grad W, and e.x = -r
            const double expected = 2 * plain(a[density]) * w.V_b * (w.U_a - w.speed) * -w.distance * w.F;
            CHECK(plain(rate(a, b, ab)) == Approx(expected).epsilon(1e-9));
            approaching += w.U_a > w.U_b;
            saturated += w.U_a - w.U_b > 10;
        }
    CHECK(approaching > 20);
    CHECK(saturated > 5);
}

// Kinetic energy and compression together lose, pair by pair, 2 V_a V_b |grad W| (beta Z_a Z_b (U_a - U_b)^2 +
// (p_a - p_b)^2)/(Z_a + Z_b).
template <int dim>
void check_energy() {
    const auto fluid = moving<dim>(brine(), 4, 3);
    const RiemannContinuity<K> rate{};
    double power = 0, lost = 0;
    for (const auto& a : fluid) {
        power += plain(a[mass]) * plain(a[velocity]).dot(plain(sum(RiemannPressure<K>::Push{}, a, fluid)));
        power += plain(a[volume]) * plain(a[pressure]) / plain(a[density]) * plain(sum(rate, a, fluid));
        for (const auto& b : fluid) {
            if (&a == &b)
                continue;
            const auto w = by_hand<dim>(a, b, 3, ColumnVector<dim>::Zero());
            const double Z = 1100 * 30, approach = std::max(w.U_a - w.U_b, 0.0);
            const double beta = std::min(3 * approach / 30, 1.0), jump = plain(a[pressure]) - plain(b[pressure]);
            lost += w.V_a * w.V_b * -w.F * w.distance * (beta * Z * Z * approach * approach + jump * jump) / (2 * Z);
        }
    }
    CHECK(lost > 0);
    CHECK(power == Approx(-lost).epsilon(1e-9));
}

template <int dim>
void check_still_water() {
    ColumnVector<dim> g = ColumnVector<dim>::Zero();
    g[dim - 1] = -9.81;
    auto fluid = block<dim>(brine(), 4, 0.2);
    for (auto& p : fluid) // in balance: c^2 drho/dx = rho g
        p.set(density, 1100 * std::exp(g.dot(plain(p[position])) / 900));
    const auto greatest_rate = [&](double supported) {
        for (auto& p : fluid)
            p.set(supported_share, supported);
        double greatest = 0;
        for (const auto& a : fluid)
            greatest = std::max(greatest, std::abs(plain(sum(RiemannContinuity<K>{}, a, fluid, g))));
        return greatest;
    };
    const double falling = greatest_rate(0); // the U* of the source
    CHECK(falling > 1);
    CHECK(greatest_rate(1) < 1e-6 * falling);
}

/// A wall below y = 0 with the first layer at -spacing/2, and a fluid above it.
template <int dim>
struct Shore {
    Cloud<dim, Bed> wall;
    Cloud<dim, Water> fluid;

    Shore() {
        ColumnVector<dim> above = ColumnVector<dim>::Zero();
        above[dim - 1] = 0.5e-3;
        // nine wide, so that the wall is flat for the particle in the middle
        for (const auto& p : block<dim>(bed(), 9, 0, 1, ColumnVector<dim>::Constant(-4e-3))) {
            ColumnVector<dim> x = plain(p[position]);
            x[dim - 1] -= 4.5e-3;
            if (x[dim - 1] > -3.1e-3) {
                wall.push_back(p);
                wall.back().set(position, vec<dim>(x));
            }
        }
        fluid = moving<dim>(brine(), 1, 4);
        fluid.front().set(position, vec<dim>(above));
    }
    auto& particle() { return fluid.front(); }
};

template <int dim>
void check_wall() {
    Shore<dim> shore;
    auto& f = shore.particle();
    ColumnVector<dim> g = ColumnVector<dim>::Zero(), sliding = ColumnVector<dim>::Zero(),
                      down = ColumnVector<dim>::Zero();
    g[dim - 1] = -9.81;
    sliding[0] = 2;
    down[dim - 1] = -0.5;
    const ColumnVector<dim> into = plain(sum(RiemannWallNormal<K>{}, f, shore.wall));
    CHECK(into.template head<dim - 1>().norm() < 1e-12 * into.norm());
    CHECK(into[dim - 1] < -100); // about 0.6/H
    f.set(wall_direction, vec<dim>(into));
    for (auto& w : shore.wall)
        w.set(volume, w[mass] / w[density]).set(velocity, Vector<Number<double>, dim>::zero());
    const RiemannWallPressure<K>::Push push{};
    auto force_with = [&](const ColumnVector<dim>& v) {
        f.set(velocity, vec<dim>(v));
        return ColumnVector<dim>(plain(sum(push, f, shore.wall, g)));
    };
    f.set(pressure, 500.0);
    // at rest: the pressure half way between the two, by hand
    ColumnVector<dim> expected = ColumnVector<dim>::Zero();
    const double V_f = plain(f[volume]), m = plain(f[mass]), rho = plain(f[density]);
    for (const auto& w : shore.wall) {
        const ColumnVector<dim> x = plain(f[position]) - plain(w[position]);
        const double p = 500 + 0.5 * rho * -g.dot(x);
        expected -= 2 / m * V_f * plain(w[volume]) * p * gradient_factor<dim>(x.norm(), 3e-3) * x;
    }
    const ColumnVector<dim> at_rest = force_with(ColumnVector<dim>::Zero());
    CHECK((at_rest - expected).norm() < 1e-12 * expected.norm());
    CHECK(at_rest[dim - 1] > 0);
    // no friction, no pull on what leaves, and rho c beta 2 U/2 more for what comes
    CHECK((force_with(sliding) - at_rest).norm() < 1e-12 * at_rest.norm());
    CHECK((force_with(-down) - at_rest).norm() < 1e-12 * at_rest.norm());
    const double U = 0.5, beta = 3 * 2 * U / 30;
    const ColumnVector<dim> more = force_with(down) - at_rest;
    const ColumnVector<dim> dissipation = -2 / m * V_f * (beta * 1100 * 30 * U) * into;
    CHECK((more - dissipation).norm() < 1e-10 * dissipation.norm());
    // the wall that comes is the same as the fluid that comes
    for (auto& w : shore.wall)
        w.set(velocity, vec<dim>(-down));
    CHECK((force_with(ColumnVector<dim>::Zero()) - at_rest - more).norm() < 1e-10 * more.norm());
    // the density rate: twice the wall's share of - rho div v
    const double rate = plain(sum(RiemannWallContinuity<K>{}, f, shore.wall));
    CHECK(rate == Approx(2 * rho * (down.dot(into))).epsilon(1e-12));
    CHECK(rate > 0);
    // a wall that must not pull
    f.set(pressure, -500.0);
    const RiemannWallPressure<K>::Push no_suction{{.suction = false}};
    f.set(velocity, vec<dim>(down * -4));
    CHECK(plain(sum(no_suction, f, shore.wall, g)).norm() == 0);
    CHECK(plain(sum(push, f, shore.wall, g))[dim - 1] < 0);
    // where there is no wall
    f.set(wall_direction, Vector<Number<double>, dim>::zero());
    CHECK(plain(sum(push, f, shore.wall, g)).allFinite());
}

template <int dim>
void check_reaction() {
    auto fluid = moving<dim>(brine(), 3, 5, 8);
    auto solid = block<dim>(soft(), 3, 0.2, 6, ColumnVector<dim>::Constant(4e-4));
    Dice dice(7);
    for (auto& p : solid)
        p.set(velocity, dice.vector<dim>(8)).set(volume, p[mass] / p[density]);
    for (auto& p : fluid)
        p.set(wall_direction, dice.vector<dim>(1));
    CHECK(worst_imbalance(RiemannWallPressure<K>::Push{}, fluid, solid) < 1e-14);
    CHECK(worst_imbalance(RiemannPressure<K>::Push{}, fluid, moving<dim>(oil(), 3, 8, 8, 4e-4)) < 1e-14);
    // under gravity, which raises the pressure at what lies deeper, seen from either side
    ColumnVector<dim> g = ColumnVector<dim>::Constant(2e4);
    g[dim - 1] = -9e4;
    const RiemannWallPressure<K>::Push push{};
    const auto& f = fluid.front();
    const auto& s = solid.front();
    const auto there = geometry<RiemannWallPressure<K>::Push, dim>(f, s, g);
    const auto back = geometry<RiemannWallPressure<K>::Push, dim>(s, f, g);
    const ColumnVector<dim> on_fluid = plain(f[mass] * contribution(there, push(f, s, there)));
    const ColumnVector<dim> on_solid = plain(s[mass] * contribution(back, push(s, f, back)));
    CHECK((on_fluid + on_solid).norm() < 1e-14 * on_fluid.norm());
    CHECK((on_fluid - given(push, f, s)).norm() > 1e-3 * on_fluid.norm()); // it does make a difference
    // the direction of the wall counts volumes as they are now
    const ColumnVector<dim> into = plain(sum(RiemannWallNormal<K>{}, f, solid));
    for (auto& p : solid)
        p.set(density, 2.0 * p[density]);
    CHECK((plain(sum(RiemannWallNormal<K>{}, f, solid)) - 0.5 * into).norm() < 1e-14 * into.norm());
}

} // namespace

TEST_CASE("the Riemann scheme is its equations, within a fluid and between two") {
    check_equations<2>(brine(), brine());
    check_equations<3>(brine(), brine());
    check_equations<2>(brine(), oil());
    check_equations<3>(oil(), brine());
}
TEST_CASE("the Riemann scheme loses the energy of its jumps, and none besides") {
    check_energy<2>();
    check_energy<3>();
}
TEST_CASE("RiemannContinuity leaves still water alone, also at its surfaces") {
    check_still_water<2>();
    check_still_water<3>();
}
TEST_CASE("a Riemann wall: hydrostatic, no friction, dissipation by the normal velocity, no pull if so asked") {
    check_wall<2>();
    check_wall<3>();
}
TEST_CASE("the Riemann forces between phases are equal and opposite") {
    check_reaction<2>();
    check_reaction<3>();
}
TEST_CASE("the Riemann scheme needs the wall to have no field of its own") {
    CHECK(sides<RiemannWallPressure<K>::Push, 2, Water, Bed>() ==
          "mass volume density velocity pressure wall_direction | volume velocity");
    CHECK(sides<RiemannWallPressure<K>::Push, 3, Sponge, Water>() ==
          "mass volume velocity | volume density velocity pressure wall_direction");
    CHECK(sides<RiemannWallNormal<K>, 3, Water, Bed>() == "| mass density");
}
TEST_CASE("the limits of the Riemann scheme, longer where nothing is fast") {
    const TimeStepInput in{3e-3, 1e-3, 1, 1, 3};
    CHECK(RiemannContinuity<K>::time_step_limit(brine(), in) == Approx(0.255 * 3e-3 / 30));
    CHECK(RiemannContinuity<K>::time_step_limit(brine(), {3e-3, 1e-3, 1, 1, 2}) == Approx(0.3 * 3e-3 / 30));
    CHECK(RiemannPressure<K>::time_step_limit(brine(), in, {}) == Approx(0.48 * 3e-3 / 6));
    CHECK(RiemannPressure<K>::time_step_limit(brine(), in, {.eta = 100}) == Approx(0.48 * 3e-3 / 30));
    CHECK(RiemannWallPressure<K>::time_step_limit(brine(), bed(), in, {}) == Approx(0.55 * 3e-3 / 6));
    CHECK(std::isinf(RiemannPressure<K>::time_step_limit(brine(), in, {.eta = 0})));
    // between two, the faster sound and both speeds count
    Water stiff = oil();
    stiff.sound_speed = 60;
    CHECK(RiemannContinuity<K>::time_step_limit(brine(), stiff, in) == Approx(0.255 * 3e-3 / 60));
    CHECK(RiemannContinuity<K>::time_step_limit(stiff, brine(), in) == Approx(0.255 * 3e-3 / 60));
    const TimeStepInput both{3e-3, 1e-3, 1, 1, 3, 1e-3, 0.5};
    CHECK(RiemannWallPressure<K>::time_step_limit(brine(), bed(), both, {}) == Approx(0.55 * 3e-3 / 9));
    // the fluid's sound counts, not that of a stiff solid
    auto steel = sponge();
    steel.sound_speed = 5000;
    CHECK(RiemannWallPressure<K>::time_step_limit(brine(), steel, in, {.eta = 100}) == Approx(0.55 * 3e-3 / 30));
    CHECK(RiemannWallPressure<K>::time_step_limit(steel, brine(), in, {.eta = 100}) == Approx(0.55 * 3e-3 / 30));
    CHECK_THROWS_AS(RiemannPressureParameters{.eta = -1}.check("Water"), Error);
    CHECK_THROWS_AS(RiemannWallPressureParameters{.eta = -1}.check("Sides"), Error);
}

} // namespace riemann_test
