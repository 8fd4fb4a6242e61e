// A dry porous column draws water in by capillary suction.
//
// Reference: a sharp front at the depth x (Green and Ampt 1911; Washburn 1921 without weight): n eta x dx/dt = k (p_c +
// rho g (D + x)), with the depth D = D_0 - n (x - x_0) of the water in front of the column; integrated in closed form.
// Geometry: plane, periodic to the sides; a column 0.2 m long that is held, and water in front of it and in its first
// 0.02 m. A small weight, g = 1 m/s^2 towards the column, keeps the two together; it is a fifth of the suction of 500
// Pa. Porosity 0.6, k = 2e-10 m^2, viscosity 1e-3 Pa s. The particles are counted over the column. Scheme: the mixture,
// InPores with a suction, SeepingFluid and PorousSkeleton; Wendland C2 of 3.9 spacings, which are 3 of the water in the
// pores, c = 10 m/s. Measure: the depth of the front, as what the pores hold, when it is to be at 0.06, 0.09 and 0.12
// m.
#pragma once

#include "case.hpp"

#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/methods/seeping_fluid.hpp>
#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/mixture/fill_pores.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <cmath>
#include <vector>

namespace validation::imbibition {

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<sph::InPores<>, sph::SeepingFluid<K>> {};
struct Column : sph::Solid<sph::TotalLagrangianSolid<sph::PorousSkeleton<>, K>, sph::Clamped> {};
struct Soaking : sph::CouplingOf<Water, Column> {};

inline std::vector<Measured> measure(int across) {
    const double L = 0.2, dx = L / across, width = 8 * dx, n = 0.6, k = 2e-10, suction = 500, rho = 1000, eta = 1e-3,
                 g = 1, at_start = 0.02, in_front = 0.096;
    sph::Solver<2, double, sph::SymplecticEuler, Water, Column, Soaking> scene(
        {.gravity = {0, g}, .support_radius = 3.9 * dx, .cfl = 0.8, .periodic_length = {width, 0}});
    const auto water = scene.add(Water{{.density = rho, .sound_speed = 10, .viscosity = eta}},
                                 sph::fill(sph::Box<2>{{0, -in_front}, {width, at_start}}, dx), dx);
    Column column{{.density = 600, .sound_speed = 5, .shear_modulus = 1e4}};
    column.set(sph::PorousSkeletonParameters{.porosity = n});
    const auto body = scene.add(column, sph::fill(sph::Box<2>{{0, 0}, {width, L}}, dx), dx);
    scene.hold(body, [](const auto&) { return true; });
    scene.coupling<Soaking>().set(sph::DarcyDragParameters{.permeability = k});
    scene.coupling<Soaking>().set(sph::PoreSpaceParameters{.suction = suction});
    sph::fill_pores(scene, water, body);

    const double slope = rho * g * (1 - n), push = suction + rho * g * (in_front + n * at_start);
    const auto time_of = [&](double x) {
        return n * eta / k *
               ((x - at_start) / slope -
                push / sph::sq(slope) * std::log((push + slope * x) / (push + slope * at_start)));
    };
    std::vector<Measured> found;
    for (const double x : {0.06, 0.09, 0.12}) {
        scene.run_until(time_of(x));
        found.push_back({sph::text("front, m, when it is to be at ", x), "2 % with 40",
                         L * scene[body][sph::saturation].mean(), x});
    }
    return found;
}

} // namespace validation::imbibition
