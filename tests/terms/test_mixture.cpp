// A fluid in a skeleton whose pores are not resolved: how much room it has, how it is dragged, pushed and drawn.
#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/heat/heat_capacity.hpp>
#include <imbibe/methods/seeping_fluid.hpp>
#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/mixture/fill_pores.hpp>
#include <imbibe/mixture/pore_heat.hpp>
#include <imbibe/monitor/energy.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solid/neo_hookean.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <catch_shim.hpp>

#include <cmath>
#include <numbers>

namespace mixture_test {

using namespace imbibe;
using K = WendlandC2;

struct Water : Fluid<InPores<>, SeepingFluid<K>> {};
struct Sponge : Solid<TotalLagrangianSolid<PorousSkeleton<CompressibleNeoHookean>, K>, Clamped> {};
struct Soaked : CouplingOf<Water, Sponge> {};
using Scene = Solver<2, double, SymplecticEuler, Water, Sponge, Soaked>;

constexpr double dx = 0.05, n_0 = 0.6, rho = 1000, eta = 0.5;
Water water() {
    return {{.density = rho, .sound_speed = 30, .viscosity = eta}};
}
Sponge sponge(double swelling = 0, double softening = 0) {
    Sponge s{{.density = 800, .sound_speed = 10, .shear_modulus = 5e4}};
    s.set(PorousSkeletonParameters{.porosity = n_0, .swelling = swelling, .softening = softening});
    return s;
}
/// A periodic square of sponge full of water.
struct Square {
    Scene scene;
    PhaseHandle<Water> liquid;
    PhaseHandle<Sponge> body;
};
Square full_square(double permeability, double gravity, double jittered = 0, int threads = 1) {
    Square s{
        Scene({.gravity = {gravity, 0}, .support_radius = 2.6 * dx, .periodic_length = {1, 1}, .threads = threads}),
        {},
        {}};
    const auto places = fill(Box<2>{{0, 0}, {1, 1}}, dx);
    s.liquid = s.scene.add(water(), jitter<2>(places, jittered * dx, 1), dx);
    s.body = s.scene.add(sponge(), places, dx);
    s.scene.coupling<Soaked>().set(DarcyDragParameters{.permeability = permeability});
    fill_pores(s.scene, s.liquid, s.body);
    return s;
}

TEST_CASE("Water in a skeleton that rests flows as Darcy says, at any permeability, in steps of the same length") {
    long long steps = 0;
    for (const double k : {1e-6, 1e-9, 1e-13}) {
        auto s = full_square(k, 2);
        s.scene.hold(s.body, [](const auto&) { return true; });
        s.scene.run_until(0.25);
        // n rho g = n^2 eta/k v
        const auto v = s.scene[s.liquid][velocity].col(0);
        CHECK(v.mean() == Approx(k * rho * 2 / (n_0 * eta)).epsilon(1e-3));
        CHECK(v.maxCoeff() == Approx(v.mean()).epsilon(1e-3));
        CHECK((steps == 0 || steps == s.scene.steps()));
        steps = s.scene.steps();
    }
}

TEST_CASE("In fast flow the drag grows as Forchheimer says") {
    auto s = full_square(1e-6, 20);
    s.scene.coupling<Soaked>().set(DarcyDragParameters{.permeability = 1e-6, .forchheimer_length = 2});
    s.scene.hold(s.body, [](const auto&) { return true; });
    s.scene.run_until(0.25);
    // rho g = n v (eta + c rho n v)/k
    const double c = 2, q = (-eta + std::sqrt(sq(eta) + 4 * c * rho * rho * 20 * 1e-6)) / (2 * c * rho);
    CHECK(s.scene[s.liquid][velocity].col(0).mean() == Approx(q / n_0).epsilon(1e-3));
}

TEST_CASE("Water and a free skeleton share their momentum exactly") {
    auto s = full_square(1e-11, 0, 0.2);
    for (int i = 0; i < s.scene[s.liquid].size(); ++i)
        s.scene[s.liquid][velocity](i, 0) = 1;
    const auto all = [&] { return Eigen::Vector2d(momentum(s.scene[s.liquid]) + momentum(s.scene[s.body])); };
    const Eigen::Vector2d before = all();
    for (int n = 0; n < 200; ++n)
        s.scene.step();
    CHECK((all() - before).norm() < 1e-12 * before.norm());
    // Both move as one: 600 of 1400 kg.
    CHECK(s.scene[s.liquid][velocity].col(0).mean() == Approx(600.0 / 1400).epsilon(0.01));
    CHECK(s.scene[s.body][velocity].col(0).mean() == Approx(600.0 / 1400).epsilon(0.01));
}

/// Half of a periodic rectangle is sponge, all of it full of water.
struct Half : Square {
    explicit Half(double suction) : Square{Scene(half()), {}, {}} {
        liquid = scene.add(water(), fill(Box<2>{{0, 0}, {1, 2}}, dx), dx);
        body = scene.add(sponge(), fill(Box<2>{{0, 0.5}, {1, 1.5}}, dx), dx);
        scene.coupling<Soaked>().set(DarcyDragParameters{.permeability = 1});
        scene.coupling<Soaked>().set(PoreSpaceParameters{.suction = suction});
        fill_pores(scene, liquid, body);
    }
    static Settings<2> half() { return {.support_radius = 2.6 * dx, .periodic_length = {1, 2}, .threads = 1}; }

    /// What pushes the sponge where the water has the pressure p(y), N/m.
    template <class Pressure>
    Eigen::Vector2d force(const Pressure& p) const {
        auto copy = scene;
        const auto view = copy[liquid];
        for (int i = 0; i < view.size(); ++i) {
            const double share = 1 + p(view[position](i, 1)) / (rho * 900);
            view[density](i) *= share;
            view[mass](i) *= share; // the volume stays
        }
        copy.step(1e-9);
        CHECK(copy[liquid][porosity].minCoeff() == Approx(n_0).epsilon(1e-3));
        CHECK(copy[liquid][porosity].maxCoeff() == 1);
        return 1e9 * momentum(copy[body]);
    }
};

TEST_CASE("A skeleton under water is lifted by what it displaces, and an even pressure pushes it nowhere") {
    const double slope = 5e3; // Pa/m, in the sponge and a support radius around it
    for (const double suction : {0.0, 500.0}) {
        const Half s(suction);
        CHECK(s.force([](double) { return 2e4; }).norm() < 2e-3 * slope * (1 - n_0));
        CHECK(s.force([=](double y) { return 2e4 - slope * (y - 1); })[1] == Approx(slope * (1 - n_0)).epsilon(0.01));
    }
}

TEST_CASE("The forces of water and skeleton are the derivative of the energy that they store") {
    auto s = full_square(1e3, 0, 0.2); // hardly any drag
    auto& scene = s.scene;
    scene.coupling<Soaked>().set(PoreSpaceParameters{.suction = 500});
    auto u = scene[s.liquid];
    auto q = scene[s.body];
    u.material().viscosity = 0;
    u.material().set(PoreDensityDiffusionParameters{.delta = 0, .delta_in_pores = 0});
    u.material().set(DensityFloorParameters{.rate = 0});
    for (int i = 0; i < q.size(); ++i)
        q[velocity](i, 0) = 0.05 * std::sin(2 * 3.14159265 * q[position](i, 1));
    const auto energy = [&] {
        return kinetic_energy(scene[s.liquid]) + kinetic_energy(scene[s.body]) + stored_energy(scene[s.liquid]) +
               stored_energy(scene[s.body]);
    };
    scene.step(1e-9);
    const double before = energy(), moving = kinetic_energy(scene[s.body]);
    double most = 0;
    for (int n = 0; n < 2000; ++n) {
        scene.step(2e-5);
        most = std::max(most, std::abs(energy() - before));
    }
    CHECK(kinetic_energy(scene[s.body]) < 0.9 * moving);
    CHECK(most < 0.02 * moving);
}

TEST_CASE("Water and skeleton move the same with one thread and with two") {
    auto one = full_square(1e-9, 2, 0.2, 1), two = full_square(1e-9, 2, 0.2, 2);
    one.scene.run_until(0.05);
    two.scene.run_until(0.05);
    CHECK((one.scene[one.liquid][position] == two.scene[two.liquid][position]));
    CHECK((one.scene[one.body][position] == two.scene[two.body][position]));
}

TEST_CASE("A full skeleton swells and softens: its law sees the strain by which it is not yet swollen") {
    const double swelling = 0.1, softening = 0.5, f = 1 / (1 + swelling);
    auto s = full_square(1e-6, 0);
    s.scene[s.body].material().set(
        PorousSkeletonParameters{.porosity = n_0, .swelling = swelling, .softening = softening});
    s.scene.step(1e-9);
    const auto q = s.scene[s.body];
    CHECK(q[saturation].minCoeff() == 1);
    const double mu = 5e4, lambda = 800 * 100 - 2 * mu / 3, J = sq(f);
    const double law = mu * (f - 1 / f) + 0.5 * lambda * (sq(J) - 1) / f; // of F = f 1
    CHECK(q[first_piola_stress].col(0).mean() == Approx((1 - softening) * (1 + swelling) * law).epsilon(1e-6));
    CHECK(q[first_piola_stress].col(1).cwiseAbs().maxCoeff() < 1e-6 * mu);
}

struct WarmWater : Fluid<InPores<>, SeepingFluid<K>, HeatCapacity, PoreHeatConduction<K>> {};
struct WarmSponge : Solid<TotalLagrangianSolid<PorousSkeleton<CompressibleNeoHookean>, K>, HeatCapacity,
                          HeatConduction<K, Reference>> {};
struct WarmSoaked : CouplingOf<WarmWater, WarmSponge, PoreHeatExchange<K>> {};

TEST_CASE("Water and skeleton share their heat exactly, and conduct it side by side") {
    // Heat that varies like a cosine decays with (n k_f + k_s)/(n rho c_f + rho_s c_s), as warm as the other
    // everywhere.
    Solver<2, double, SymplecticEuler, WarmWater, WarmSponge, WarmSoaked> scene(
        {.support_radius = 3 * dx, .max_time_step = 1e3, .periodic_length = {1, 1}, .threads = 1});
    const auto places = fill(Box<2>{{0, 0}, {1, 1}}, dx);
    WarmWater liquid{{.density = rho, .sound_speed = 1e-3, .viscosity = eta}};
    liquid.set(HeatParameters{.heat_capacity = 4, .heat_conductivity = 600, .reference_temperature = 0});
    const auto fluid = scene.add(liquid, places, dx);
    WarmSponge dry{{.density = 800, .sound_speed = 1e-3, .shear_modulus = 1e-4}};
    dry.set(PorousSkeletonParameters{.porosity = n_0});
    dry.set(HeatParameters{.heat_capacity = 2, .heat_conductivity = 100, .reference_temperature = 0});
    const auto body = scene.add(dry, places, dx);
    scene.coupling<WarmSoaked>().set(DarcyDragParameters{.permeability = 1e-9});
    fill_pores(scene, fluid, body);
    const double wave = 2 * std::numbers::pi;
    auto water = scene[fluid];
    const auto sponge = scene[body];
    for (int i = 0; i < water.size(); ++i)
        water[enthalpy](i) = 1 + std::cos(wave * water[position](i, 0)); // the skeleton is cold
    const double all = thermal_energy(water), held = n_0 * rho * 4 + 800 * 2, diffusivity = (n_0 * 600 + 100) / held,
                 end = 1 / (wave * wave * diffusivity);
    scene.run_until(0.2 * end); // until both are as warm
    const auto amplitude = [&](const auto& phase) {
        double sum = 0;
        for (int i = 0; i < phase.size(); ++i)
            sum += 2 * phase[temperature](i) * std::cos(wave * phase[position](i, 0)) / phase.size();
        return sum;
    };
    const double before = amplitude(water);
    CHECK(amplitude(sponge) == Approx(before).epsilon(0.05));
    scene.run_until(end);
    CHECK(thermal_energy(water) + thermal_energy(sponge) == Approx(all).epsilon(1e-12));
    CHECK(water[temperature].mean() == Approx(n_0 * rho / held).epsilon(1e-6)); // 1 J/kg in the water
    CHECK(amplitude(water) / before == Approx(std::exp(-0.8)).epsilon(0.02));
}

TEST_CASE("Numbers of pores that cannot be are named") {
    const auto refused = [](const Sponge& given, double permeability, double suction, const char* words) {
        Scene scene({.support_radius = 3 * dx});
        scene.add(water(), fill(Box<2>{{0, 0}, {1, 1}}, dx), dx);
        const auto prepare = [&] {
            scene.add(given, fill(Box<2>{{0, 0}, {1, 1}}, dx), dx);
            scene.coupling<Soaked>().set(DarcyDragParameters{.permeability = permeability});
            scene.coupling<Soaked>().set(PoreSpaceParameters{.suction = suction});
            scene.step();
        };
        CHECK_THROWS_WITH(prepare(), imbibe_test::contains(words));
    };
    refused({{.density = 800, .sound_speed = 10, .shear_modulus = 5e4}}, 1e-9, 0, "porosity = -1 (not given)");
    refused(sponge(2), 1e-9, 0, "swelling = 2");
    refused(sponge(0, 1), 1e-9, 0, "softening = 1");
    refused(sponge(), 0, 0, "permeability = 0 m^2");
    refused(sponge(), 1e-9, -1, "suction = -1 Pa");
}

} // namespace mixture_test
