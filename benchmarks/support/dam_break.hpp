// The dam break of examples/dam_break.cpp with any spacing, for measuring whole steps and runs.
#pragma once

#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/methods/weakly_compressible.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/tait.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <cmath>

namespace imbibe::bench {

struct DamBreakWater : Fluid<Tait<7>, WeaklyCompressible<WendlandC2>, MonaghanViscosity<WendlandC2>> {};
struct Tank : Wall<> {};
struct TankSides : CouplingOf<DamBreakWater, Tank> {};

/// The scene of examples/dam_break.cpp.
template <class Real, int search_interval = 100>
struct DamBreak {
    using Scene = Solver<3, Real, SymplecticEuler, DamBreakWater, Tank, TankSides>;
    /// With a spacing dx, m, and the water at rest.
    static Scene at_rest(double dx, int threads) {
        Scene scene({.gravity = {0, 0, -9.81},
                     .support_radius = 2.6 * dx,
                     .search_interval = search_interval,
                     .search_skin = 0.1, // for an interval above 1
                     .threads = threads});
        DamBreakWater water{{.density = 1000, .sound_speed = 45}};
        water.set(MonaghanViscosityParameters{.alpha = 0.02, .beta = 1});
        scene.add(water, fill(Box<3>({0, 0, 0}, {0.5, 0.3, 0.5}), dx), dx);
        scene.add(Tank{{.density = 1000}}, tank(Box<3>({0, 0, 0}, {1.6, 0.3, 0.8}), dx, 3, Sides::z_high), dx);
        return scene;
    }
    /// In any size. The water already runs, at its front with the 2 sqrt(g height) that it may come to: the slower it
    /// is, the more steps a search serves.
    static Scene make(int particles, int threads) {
        auto scene = at_rest(std::cbrt(0.5 * 0.3 * 0.5 / particles), threads);
        const auto water = scene.template get<DamBreakWater>();
        const double front = 2 * std::sqrt(9.81 * 0.5);
        for (int i = 0; i < water.size(); ++i)
            water[velocity](i, 0) = static_cast<Real>(front * water[position](i, 0) / 0.5);
        return scene;
    }
};

} // namespace imbibe::bench
