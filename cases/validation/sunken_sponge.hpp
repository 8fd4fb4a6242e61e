// A sponge that is held in water at rest is lifted by what its struts displace, in the first steps and after 100,000.
//
// Reference: Archimedes. Geometry: plane, a tank 1 m wide with 1 m of water, in its middle a sponge of 0.5 m x 0.4 m;
// the particles are counted over the tank. Porosity 0.7, k = 1e-6 m^2, viscosity 0.1 Pa s, c = 44 m/s. Scheme: the
// mixture, InPores, SeepingFluid and PorousSkeleton; Wendland C2 of 3 spacings. Measure: the lift over the weight of
// the displaced water, in a mean over 20,000 steps.
#pragma once

#include "case.hpp"

#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/methods/seeping_fluid.hpp>
#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/mixture/fill_pores.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/hydrostatic.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <vector>

namespace validation::sunken_sponge {

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<sph::InPores<>, sph::SeepingFluid<K>, sph::MorrisViscosity<K>> {};
struct Sponge : sph::Solid<sph::TotalLagrangianSolid<sph::PorousSkeleton<>, K>, sph::Clamped> {};
struct Tank : sph::Wall<> {};
struct Soaked : sph::CouplingOf<Water, Sponge> {};
struct Sides : sph::CouplingOf<Water, Tank> {};

struct Bath {
    static constexpr double n = 0.7, height = 0.4, rho = 1000, g = 9.81;
    sph::Solver<2, double, sph::SymplecticEuler, Water, Sponge, Tank, Soaked, Sides> scene;
    sph::PhaseHandle<Water> water;
    sph::PhaseHandle<Sponge> sponge;

    explicit Bath(int across) : scene({.gravity = {0, -g}, .support_radius = 3.0 / across, .cfl = 0.8}) {
        const double dx = 1.0 / across;
        const sph::Box<2> inside{{0, 0}, {1, 1}};
        water = scene.add(Water{{.density = rho, .sound_speed = 44, .viscosity = 0.1}}, sph::fill(inside, dx), dx);
        Sponge body{{.density = (1 - n) * rho, .sound_speed = 40, .shear_modulus = 2e5}};
        body.set(sph::PorousSkeletonParameters{.porosity = n});
        sponge = scene.add(body, sph::fill(sph::Box<2>{{0.25, 0.3}, {0.75, 0.3 + height}}, dx), dx);
        scene.add(Tank{{.density = rho}}, sph::tank(inside, dx, 3, sph::Sides::y_high), dx);
        scene.coupling<Soaked>().set(sph::DarcyDragParameters{.permeability = 1e-6});
        scene.hold(sponge, [](const auto&) { return true; });
        sph::start_hydrostatic(scene, water, 1.0);
        sph::fill_pores(scene, water, sponge);
    }
};

inline std::vector<Measured> measure(int across) {
    Bath bath(across);
    const double weight = bath.scene[bath.sponge][sph::mass].sum() * bath.g; // its struts are as dense as water
    const auto lift = [&](int steps) { // over the weight; of an acceleration that has its own weight in it
        double sum = 0;
        for (int i = 0; i < steps; ++i) {
            bath.scene.step();
            const auto body = bath.scene[bath.sponge];
            sum += 1 + (body[sph::mass].transpose() * body[sph::acceleration].col(1))(0) / weight;
        }
        return sum / steps;
    };
    std::vector<Measured> found;
    found.push_back({"lift over weight of displaced water, 20,000 steps", "1 %", lift(20000), 1});
    lift(60000);
    found.push_back({"the same, the last of 100,000 steps", "1 %", lift(20000), 1});
    return found;
}

} // namespace validation::sunken_sponge
