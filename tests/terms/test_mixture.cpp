// A fluid in a skeleton whose pores are not resolved: how much room it has, and how it is dragged and pushed.
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/mixture/darcy_drag.hpp>
#include <imbibe/mixture/fill_pores.hpp>
#include <imbibe/mixture/pore_pressure.hpp>
#include <imbibe/monitor/energy.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <catch_shim.hpp>

#include <cmath>

namespace mixture_test {

using namespace imbibe;
using K = WendlandC2;

struct Water : Fluid<InPores<>, VolumeContinuity<K>, VolumePressure<K>, PoreDensityDiffusion<K>> {};
struct Sponge : Solid<TotalLagrangianSolid<PorousSkeleton<>, K>, Clamped> {};
struct Soaked : Coupling<Water, Sponge, Into<Water, PoreSpace<K>>, Into<Sponge, PoreContents<K>>, PorePressure<K>, DarcyDrag<K>> {};
using Scene = Solver<2, double, SymplecticEuler, Water, Sponge, Soaked>;

constexpr double dx = 0.05, n_0 = 0.6, rho = 1000, eta = 0.5;
Water water() {
    return {{.density = rho, .sound_speed = 30, .viscosity = eta}};
}
Sponge sponge() {
    Sponge s{{.density = 800, .sound_speed = 10, .shear_modulus = 5e4}};
    s.set(PorousSkeletonParameters{.porosity = n_0});
    return s;
}
/// A periodic square of sponge full of water.
struct Square {
    Scene scene;
    PhaseHandle<Water> liquid;
    PhaseHandle<Sponge> body;
};
Square full_square(double permeability, double gravity, double jittered = 0) {
    Square s{Scene({.gravity = {gravity, 0}, .support_radius = 2.6 * dx, .periodic_length = {1, 1}, .threads = 1}),
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

TEST_CASE("A pressure that is the same everywhere pushes water through a skeleton nowhere; one that rises lifts it") {
    // Half of a periodic square is sponge, all of it full of water.
    Scene scene({.support_radius = 2.6 * dx, .periodic_length = {1, 2}, .threads = 1});
    const auto liquid = scene.add(water(), fill(Box<2>{{0, 0}, {1, 2}}, dx), dx);
    const auto body = scene.add(sponge(), fill(Box<2>{{0, 0.5}, {1, 1.5}}, dx), dx);
    scene.coupling<Soaked>().set(DarcyDragParameters{.permeability = 1});
    fill_pores(scene, liquid, body);
    const double slope = 5e3; // Pa/m, in the sponge and a support radius around it
    const auto force = [&](bool slopes) {
        auto copy = scene;
        const auto view = copy[liquid];
        for (int i = 0; i < view.size(); ++i) {
            const double p = 2e4 - (slopes ? slope * (view[position](i, 1) - 1) : 0);
            view[density](i) *= 1 + p / (rho * 900);
            view[mass](i) *= 1 + p / (rho * 900); // the volume stays
        }
        copy.step(1e-9);
        CHECK(copy[liquid][porosity].minCoeff() == Approx(n_0).epsilon(1e-3));
        CHECK(copy[liquid][porosity].maxCoeff() == 1);
        return Eigen::Vector2d(1e9 * momentum(copy[body]));
    };
    // Times the area, and as much as the kernel's gradient of a straight line is off on this lattice: so is that by which
    // the pressure bears the weight of water at rest.
    const Lattice<2> lattice{dx, 2.6 * dx};
    const double gradient =
        -0.5 * lattice.volume() * lattice.sum([](const auto& ab) { return sq(ab.distance) * ab.gradient(K{}); });
    const double buoyancy = gradient * slope * (1 - n_0);
    CHECK(gradient == Approx(1).epsilon(0.03));
    CHECK(force(false).norm() < 1e-3 * buoyancy);
    CHECK(force(true)[1] == Approx(buoyancy).epsilon(0.005));
}

} // namespace mixture_test
