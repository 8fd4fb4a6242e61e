// The scheme of the cases in which water under gravity runs against walls and what yields to it: that of
// examples/elastic_gate.cpp, in double. Wendland C2 of 2.6 spacings for the water, density diffusion and floor,
// MonaghanViscosity with alpha = 0.02, walls that do not pull, the rubber sub-cycled. Its own support is 1.5 spacings,
// its modulus that of bending_modulus.
#pragma once

#include "free_surface.hpp"
#include "solid.hpp"

#include <imbibe/fluid/density_floor.hpp>
#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/time/subcycled.hpp>

namespace validation::hydroelastic {

using K = sph::WendlandC2;
struct Column : Water<K, sph::DensityFloor, sph::MonaghanViscosity<K>> {};
struct Rubber
    : sph::Solid<sph::TotalLagrangianSolid<sph::StVenantKirchhoff, K>, sph::Clamped, sph::TimeAveragedMotion> {};
struct Tank : sph::Wall<> {};
template <class Solid, class... More>
struct Push : sph::Coupling<Column, Solid, sph::Into<Solid, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                            sph::Into<Column, sph::VolumeContinuity<K>>, More...> {};
using Scene = sph::Solver<2, double, sph::Subcycled<Rubber>, Column, Rubber, Tank, Push<Rubber>, Push<Tank>>;

constexpr double gravity = 9.81; // m/s^2

/// A scene without particles.
inline Scene scene_of(double spacing) {
    Scene scene(
        {.gravity = {0, -gravity}, .support_radius = 2.6 * spacing, .cfl = 0.4, .search_interval = 4, .threads = 1});
    const sph::PressureExtrapolationParameters no_suction{.suction = false};
    scene.coupling<Push<Rubber>>().set(no_suction);
    scene.coupling<Push<Tank>>().set(no_suction);
    return scene;
}

/// Water whose sound is ten times as fast as what falls from its surface.
inline Column column(double depth) {
    Column water{{.density = 1000, .sound_speed = 10 * std::sqrt(2 * gravity * depth)}};
    water.set(sph::MonaghanViscosityParameters{.alpha = 0.02});
    return water;
}

/// @param young    Young's modulus, Pa
/// @param poisson  Poisson's ratio
/// @param density  kg/m^3
/// @param across   particles over the thickness
inline Rubber rubber(double young, double poisson, double density, int across, double spacing) {
    Rubber material = elastic<Rubber>(sph::bending_modulus(young, across), poisson, density);
    material.support_radius = 1.5 * spacing;
    return material;
}

} // namespace validation::hydroelastic
