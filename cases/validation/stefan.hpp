// Water that freezes from a cold wall on (Stefan), and that is warmer than its melting point before it does (Neumann).
//
// Reference: exact (Carslaw and Jaeger 1959, sections 11.2 and 11.3), the front at x = 2 lambda sqrt(kappa t), with
// lambda from an equation of one unknown, solved here; that of Stefan's problem is lambda exp(lambda^2) erf(lambda) =
// St/sqrt(pi).
// Geometry: a strip of 8 particles, periodic along the wall, 1.3 long (3 with water that is warm, whose far end stays
// as it is), a lattice. The wall is 1 K below the melting point; k = rho = c = 1 in the ice, St = c 1 K/L. The warm
// water is 0.5 K above it, with twice the heat capacity and 0.3 of the conductivity.
// Scheme: Melting, HeatConduction; HeatTransfer with a wall of SurfaceTemperature, TemperatureExtrapolation; Wendland
// C2 of 3 spacings. Measure: when the exact front is at 0.6, the thickness of the ice, the temperature at 0.3, and the
// heat that ice and water lost over that which the wall took.
#pragma once

#include "case.hpp"

#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/heat/conduction.hpp>
#include <imbibe/heat/melting.hpp>
#include <imbibe/heat/surface_temperature.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/monitor/energy.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace validation::stefan {

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<sph::Melting, sph::HeatConduction<K>> {};
struct Cold : sph::Wall<sph::SurfaceTemperature> {};
struct AtWall : sph::Coupling<Water, Cold, sph::Into<Cold, sph::TemperatureExtrapolation<K>>, sph::HeatTransfer<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Cold, AtWall>;

/// One run.
struct Run {
    double across = 40;       ///< particles in a length of 1
    double stefan_number = 1; ///< c 1 K/L
    double warm = 0;          ///< by how much the water is warmer than the melting point, K
    double liquid_heat_capacity = 1, liquid_conductivity = 1;
};
/// What is seen of it.
struct Seen {
    double front = 0;       ///< at the end
    double temperature = 0; ///< then at x = 0.3, K
    double heat = 0;        ///< lost by the water, over what the wall took
};

/// The exact solution: x = 2 lambda sqrt(t).
inline double front_number(const Run& run) {
    const double ratio = std::sqrt(run.liquid_conductivity / run.liquid_heat_capacity); // sqrt(kappa_l/kappa_s)
    const auto excess = [&](double x) { // the heat that arrives less that which is taken, falls with x
        const double y = x / ratio;
        const double of_water = run.warm * run.liquid_conductivity / ratio * std::exp(-y * y) / std::erfc(y);
        return std::exp(-x * x) / std::erf(x) - of_water - x * std::sqrt(std::numbers::pi) / run.stefan_number;
    };
    double low = 1e-6, high = 3;
    for (int k = 0; k < 200; ++k)
        (excess(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
    return low;
}
inline double temperature_at(const Run& run, double lambda, double x, double t) {
    const double s = x / (2 * std::sqrt(t));
    if (s < lambda)
        return std::erf(s) / std::erf(lambda) - 1;
    const double ratio = std::sqrt(run.liquid_conductivity / run.liquid_heat_capacity);
    return run.warm == 0 ? 0 : run.warm * (1 - std::erfc(s / ratio) / std::erfc(lambda / ratio));
}

inline Seen freeze(const Run& run) {
    const double spacing = 1 / run.across, length = run.warm > 0 ? 3 : 1.3, width = 8 * spacing;
    const double lambda = front_number(run), end = sph::sq(0.6 / (2 * lambda));
    Scene scene({.support_radius = 3 * spacing, .cfl = 0.8, .periodic_length = {0, width}, .threads = 1});
    Water water{{.density = 1, .sound_speed = 1}};
    const sph::MeltingParameters melting{.solid_heat_capacity = 1,
                                         .liquid_heat_capacity = run.liquid_heat_capacity,
                                         .solid_conductivity = 1,
                                         .liquid_conductivity = run.liquid_conductivity,
                                         .latent_heat = 1 / run.stefan_number,
                                         .melting_temperature = 0,
                                         .reference_temperature = run.warm};
    water.set(melting);
    const auto ice = scene.add(water, sph::fill(sph::Box<2>({0, 0}, {length, width}), spacing), spacing);
    Cold cold{{.density = 1}};
    cold.set(sph::SurfaceTemperatureParameters{.surface_temperature = -1});
    const auto wall = scene.add(cold, sph::fill(sph::Box<2>({-3 * spacing, 0}, {0, width}), spacing), spacing);
    Seen seen;
    scene.run_until(end);
    const auto view = scene[ice];
    double weight = 0;
    for (int i = 0; i < view.size(); ++i) {
        seen.front += (1 - view[sph::liquid_fraction](i)) * sph::sq(spacing) / width;
        const double near_half = std::max(0.0, 1 - std::abs(view[sph::position](i, 0) - 0.3) / spacing);
        weight += near_half;
        seen.temperature += near_half * view[sph::temperature](i);
    }
    seen.temperature /= weight;
    seen.heat = -sph::thermal_energy(view) / sph::thermal_energy(scene[wall]);
    return seen;
}

inline std::vector<Measured> measure(int across) {
    std::vector<Measured> found;
    const auto add = [&](const std::string& what, const Run& run) {
        const Seen seen = freeze(run);
        found.push_back({sph::text("ice, ", what), "0.5 % with 40", seen.front, 0.6});
        const double lambda = front_number(run), end = sph::sq(0.6 / (2 * lambda));
        found.push_back({sph::text("temperature at half of it, K, ", what), "none given", seen.temperature,
                         temperature_at(run, lambda, 0.3, end)});
        found.push_back({sph::text("heat lost over heat taken, ", what), "1e-12", seen.heat, 1});
    };
    for (const double stefan : {0.1, 1.0})
        add(sph::text("St = ", stefan), {.across = double(across), .stefan_number = stefan});
    add("St = 1, warm water", {.across = double(across),
                               .stefan_number = 1,
                               .warm = 0.5,
                               .liquid_heat_capacity = 2,
                               .liquid_conductivity = 0.3});
    return found;
}

} // namespace validation::stefan
