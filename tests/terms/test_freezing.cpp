// What is frozen comes to rest, moves with what it freezes to, and bends; implicit drags at any stiffness, with exact
// momentum; ice that becomes a phase of its own.
#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/heat/conduction.hpp>
#include <imbibe/heat/enthalpy_porosity.hpp>
#include <imbibe/heat/frozen_drag.hpp>
#include <imbibe/heat/frozen_stress.hpp>
#include <imbibe/heat/melting.hpp>
#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/methods/weakly_compressible.hpp>
#include <imbibe/monitor/energy.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/leapfrog.hpp>
#include <imbibe/time/position_verlet.hpp>
#include <imbibe/time/staggered_leapfrog.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <catch_shim.hpp>

#include <cmath>

namespace freezing_test {

using namespace imbibe;
using K = WendlandC2;

template <class... More>
using WaterWith = Fluid<LinearState, WeaklyCompressible<K>, Instead<DensityFloor>, MorrisViscosity<K>, Melting,
                        HeatConduction<K>, More...>;
struct Mould : WaterWith<EnthalpyPorosity> {};
struct Plain : WaterWith<> {};
constexpr double latent = 1e5;
template <class Water>
Water water() {
    Water w{{.density = 1000, .sound_speed = 10, .viscosity = 1}};
    w.set(MeltingParameters{.solid_heat_capacity = 2000,
                            .liquid_heat_capacity = 4000,
                            .solid_conductivity = 1e-6,
                            .liquid_conductivity = 1e-6,
                            .latent_heat = latent,
                            .melting_temperature = 0,
                            .reference_temperature = 0});
    return w;
}

TEMPLATE_TEST_CASE("Ice stands still in a mould, mush is slowed down by Darcy's law, water falls", "", SymplecticEuler,
                   Leapfrog, PositionVerlet, StaggeredLeapfrog) {
    Solver<2, double, TestType, Mould> scene({.gravity = {0, -2}, .support_radius = 0.3, .threads = 1});
    Mould w = water<Mould>();
    const FrozenDragParameters drag{.drag = 1e4, .mush_limit = 1e-3};
    w.set(drag);
    const auto cell = scene.add(w, {{0, 0}, {1, 0}, {2, 0}}, 0.1);
    scene[cell][enthalpy](0) = -latent;       // ice
    scene[cell][enthalpy](1) = -0.4 * latent; // mush, 0.6 of it liquid
    scene[cell][velocity](0, 0) = 3;          // stops in a few steps
    for (int n = 0; n < 50; ++n) {            // L dt = 10: it halves at least in each, and never grows
        scene.step(1e-3);
        CHECK(std::abs(scene[cell][velocity](0, 0)) < 3);
    }
    CHECK(std::abs(scene[cell][velocity](0, 0)) < 1e-9);
    for (int n = 50; n < 2000; ++n)
        scene.step(1e-3);
    const auto terminal = [&](double f) { // the weight is borne by the drag
        return -2 * 1000 / (1e4 * sq(1 - f) / (power<3>(f) + 1e-3));
    };
    const auto view = scene[cell];
    for (int i = 0; i < 3; ++i) {
        const double f = view[liquid_fraction](i);
        if (f < 1)
            CHECK(view[velocity](i, 1) == Approx(terminal(f)).epsilon(1e-6));
        else
            CHECK(view[velocity](i, 1) == Approx(-4).epsilon(1e-3));
    }
}

TEST_CASE("A drag of any stiffness moves ice with the solid it froze to, and no momentum is lost") {
    struct Rubber : Solid<TotalLagrangianSolid<StVenantKirchhoff, K>> {};
    struct Bond : Coupling<Plain, Rubber, FrozenDrag<K>> {};
    for (const double A : {1e4, 1e8, 1e12}) {
        Solver<2, double, SymplecticEuler, Plain, Rubber, Bond> scene({.support_radius = 0.3, .threads = 1});
        const auto ice = scene.add(water<Plain>(), fill(Box<2>{{0, 0}, {1, 0.2}}, 0.1), 0.1);
        const auto solid = scene.add(Rubber{{.density = 1000, .sound_speed = 10, .shear_modulus = 3e4}},
                                     fill(Box<2>{{0, -0.6}, {1, 0}}, 0.1), 0.1);
        scene.template coupling<Bond>().set(FrozenDragParameters{.drag = A});
        for (int i = 0; i < scene[ice].size(); ++i)
            scene[ice][enthalpy](i) = -latent;
        for (int i = 0; i < scene[solid].size(); ++i)
            scene[solid][velocity](i, 0) = 0.1;
        const Eigen::Vector2d before = momentum(scene[ice]) + momentum(scene[solid]);
        for (int n = 0; n < 400; ++n)
            scene.step();
        const Eigen::Vector2d after = momentum(scene[ice]) + momentum(scene[solid]);
        CHECK((after - before).norm() < 1e-12 * before.norm());
        // Both move as one, but for waves in the rubber: 0.1 m/s times the solid's share of the mass.
        CHECK(scene[ice][velocity].col(0).mean() == Approx(0.075).epsilon(0.06));
        CHECK(scene[solid][velocity].cwiseAbs().maxCoeff() < 0.2); // nothing grows
    }
}

TEST_CASE("Frozen layers hang on to a wall and bear shear, molten ones flow") {
    struct Ice : WaterWith<VelocityGradient<K>, FrozenStress<K>> {};
    struct Base : Wall<> {};
    struct AtBase : CouplingOf<Ice, Base, MorrisViscosity<K>, Into<Ice, FrozenDrag<K>>> {};
    const double spacing = 0.1, G = 2e4, g = 1;
    Solver<2, double, SymplecticEuler, Ice, Base, AtBase> scene(
        {.gravity = {g, 0}, .support_radius = 3 * spacing, .periodic_length = {1, 0}, .threads = 1});
    Ice w = water<Ice>();
    w.set(FrozenStressParameters{.shear_modulus = G});
    const auto layers = scene.add(w, fill(Box<2>{{0, 0}, {1, 1}}, spacing), spacing);
    scene.add(Base{{.density = 1000}}, fill(Box<2>{{0, -0.3}, {1, 0}}, spacing), spacing);
    const auto at_start = scene[layers];
    for (int i = 0; i < at_start.size(); ++i)
        at_start[enthalpy](i) = -latent;
    // It swings about the deflection rho g y (L - y/2)/G of a layer of thickness L, whose mean is rho g L^2/(3 G).
    double shift = 0, fastest = 0, mean_shift = 0;
    const double period = 4 / std::sqrt(G / 1000); // of the first shear wave, 0.89 s
    int n = 0;
    double last = 0;
    scene.run_until(4 * period, [&](const auto& s) {
        const double u = s[layers][velocity].col(0).mean();
        shift += u * (s.time() - last);
        last = s.time();
        fastest = std::max(fastest, std::abs(u));
        mean_shift += shift;
        ++n;
    });
    mean_shift /= n;
    const double still = 1000 * g / (3 * G);
    CHECK(mean_shift == Approx(still).epsilon(0.25));
    CHECK(fastest < 0.2); // water would reach 3.6 m/s
    // Where it melts, the stress is gone and it flows.
    for (int i = 0; i < scene[layers].size(); ++i)
        scene[layers][enthalpy](i) = 0;
    scene.run_until(scene.time() + 0.5);
    CHECK(scene[layers][deviatoric_stress].cwiseAbs().maxCoeff() == 0);
    CHECK(scene[layers][velocity].col(0).mean() > 0.2);
}

TEST_CASE("What has frozen becomes a phase of its own, with its heat") {
    struct Touch : CouplingOf<Plain, Mould, MorrisViscosity<K>, HeatTransfer<K>> {};
    Solver<2, double, SymplecticEuler, Plain, Mould, Touch> scene({.support_radius = 0.3, .threads = 1});
    const auto liquid = scene.add(water<Plain>(), fill(Box<2>{{0, 0}, {1, 1}}, 0.1), 0.1);
    const auto block = scene.add(water<Mould>(), {{-0.05, 0.05}}, 0.1);
    for (int i = 0; i < scene[liquid].size(); ++i)
        if (scene[liquid][position](i, 0) < 0.3)
            scene[liquid][enthalpy](i) = -1.5 * latent;
    scene.step();
    const double before = thermal_energy(scene[liquid]) + thermal_energy(scene[block]);
    const auto moved =
        scene.hand_over(liquid, block, [](const auto& view, int i) { return view[liquid_fraction](i) == 0; });
    CHECK(moved.size() == 30);
    CHECK(scene[block].size() == 31);
    CHECK(scene[liquid].size() == 70);
    CHECK(thermal_energy(scene[liquid]) + thermal_energy(scene[block]) == Approx(before).epsilon(1e-14));
    CHECK(scene[block][enthalpy].minCoeff() == Approx(-1.5 * latent).epsilon(1e-6));
    scene.step();
}

} // namespace freezing_test
