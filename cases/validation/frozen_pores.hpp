// Water freezes in the pores of a skeleton from a cold wall on, the skeleton at rest or in motion.
//
// Reference: Stefan's problem with the latent heat n L, the conductivity n k_f + k_s and the heat capacity n rho c_f +
// rho_s c_s per volume (case stefan). In motion nothing changes but where things are.
// Geometry: that of the case stefan; in motion water and skeleton slide along the wall by a length of 0.5. Porosity
// 0.5, k = rho = c = 1 in water and ice, k_s = rho_s c_s = 0.5 of the dry skeleton, so that the means are 1. Scheme:
// the mixture, with Melting, PoreHeatConduction, PoreHeatExchange; FrozenDrag holds the ice to the skeleton. Wendland
// C2 of 3 spacings. Measure: the thickness of the ice when it is to be 0.6, the difference of the temperatures of water
// and skeleton, the heat that both lost over that which the wall took; in motion also how fast the ice moves.
#pragma once

#include "stefan.hpp"

#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/heat/frozen_drag.hpp>
#include <imbibe/heat/heat_capacity.hpp>
#include <imbibe/methods/seeping_fluid.hpp>
#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/mixture/fill_pores.hpp>
#include <imbibe/mixture/pore_heat.hpp>

#include <algorithm>

namespace validation::frozen_pores {

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<sph::InPores<>, sph::SeepingFluid<K>, sph::Melting, sph::PoreHeatConduction<K>> {};
struct Skeleton : sph::Solid<sph::TotalLagrangianSolid<sph::PorousSkeleton<>, K>, sph::HeatCapacity,
                             sph::HeatConduction<K, sph::Reference>> {};
struct Cold : sph::Wall<sph::SurfaceTemperature> {};
struct Soaking : sph::CouplingOf<Water, Skeleton, sph::PoreHeatExchange<K>, sph::FrozenDrag<K>> {};
template <class Phase>
struct AtWall : sph::Coupling<Phase, Cold, sph::Into<Cold, sph::TemperatureExtrapolation<K>>, sph::HeatTransfer<K>> {};
using Scene =
    sph::Solver<2, double, sph::SymplecticEuler, Water, Skeleton, Cold, Soaking, AtWall<Water>, AtWall<Skeleton>>;

inline std::vector<Measured> freeze(int across, double stefan_number, double way, const std::string& what) {
    const double spacing = 1.0 / across, length = 1.3, width = 8 * spacing, n = 0.5;
    const double lambda = stefan::front_number({.stefan_number = stefan_number}), end = sph::sq(0.6 / (2 * lambda)),
                 speed = way / end;
    Scene scene({.support_radius = 3 * spacing, .cfl = 0.8, .periodic_length = {0, width}, .threads = 1});
    Water liquid{{.density = 1, .sound_speed = 1, .viscosity = 1e-3}};
    liquid.set(sph::MeltingParameters{.solid_heat_capacity = 1,
                                      .liquid_heat_capacity = 1,
                                      .solid_conductivity = 1,
                                      .liquid_conductivity = 1,
                                      .latent_heat = 1 / (n * stefan_number),
                                      .melting_temperature = 0,
                                      .reference_temperature = 0});
    const auto places = sph::fill(sph::Box<2>({0, 0}, {length, width}), spacing);
    const auto water = scene.add(liquid, places, spacing);
    Skeleton dry{{.density = 0.5, .sound_speed = 1, .shear_modulus = 0.2}};
    dry.set(sph::PorousSkeletonParameters{.porosity = n});
    dry.set(sph::HeatParameters{.heat_capacity = 1, .heat_conductivity = 0.5, .reference_temperature = 0});
    const auto body = scene.add(dry, places, spacing);
    Cold cold{{.density = 1}};
    cold.set(sph::SurfaceTemperatureParameters{.surface_temperature = -1});
    const auto wall = scene.add(cold, sph::fill(sph::Box<2>({-3 * spacing, 0}, {0, width}), spacing), spacing);
    scene.coupling<Soaking>().set(sph::DarcyDragParameters{.permeability = 1e-6});
    sph::fill_pores(scene, water, body);
    scene[water][sph::velocity].col(1).setConstant(speed);
    scene[body][sph::velocity].col(1).setConstant(speed);

    scene.run_until(end);
    double front = 0, apart = 0, motion = 0, ice = 0;
    const auto view = scene[water];
    const auto other = scene[body];
    for (int i = 0; i < view.size(); ++i) {
        const double frozen = 1 - view[sph::liquid_fraction](i);
        front += frozen * sph::sq(spacing) / width;
        motion += frozen * view[sph::velocity](i, 1);
        ice += frozen;
    }
    // Both were added in the same places; the skeleton has the temperature of the nearest layer of water.
    const double middle = 0.3;
    double sums[2]{}, weights[2]{};
    const auto average = [&](const auto& phase, int k) {
        for (int i = 0; i < phase.size(); ++i) {
            const double near_it = std::max(0.0, 1 - std::abs(phase[sph::position](i, 0) - middle) / (2 * spacing));
            sums[k] += near_it * phase[sph::temperature](i);
            weights[k] += near_it;
        }
    };
    average(view, 0);
    average(other, 1);
    apart = 1 + sums[1] / weights[1] - sums[0] / weights[0];
    std::vector<Measured> found{
        {sph::text("ice, ", what), "0.5 % with 40", front, 0.6},
        {sph::text("1 + skeleton's temperature less water's at 0.3, K, ", what), "none given", apart, 1},
        {sph::text("heat lost over heat taken, ", what), "1e-12",
         -(sph::thermal_energy(view) + sph::thermal_energy(other)) / sph::thermal_energy(scene[wall]), 1}};
    if (speed > 0)
        found.push_back(
            {sph::text("speed of the ice over the skeleton's, ", what), "none given", motion / ice / speed, 1});
    return found;
}

inline std::vector<Measured> measure(int across) {
    std::vector<Measured> found;
    const auto add = [&](const std::string& what, double stefan_number, double way) {
        for (const Measured& one : freeze(across, stefan_number, way, what))
            found.push_back(one);
    };
    add("St = 0.1", 0.1, 0);
    add("St = 1", 1, 0);
    add("St = 1, in motion", 1, 0.5);
    return found;
}

} // namespace validation::frozen_pores
