// Two layers at rest in a tank, the lower one up to a thousand times as dense as the upper one.
//
// Reference: hydrostatics, and rest.
// Geometry: two layers of a height of 1 in a tank of 1 by 2 with a ceiling, periodic along x; rho = 1000 under 800 and
// 1, g = 1, kinematic viscosity 0.01.
// Scheme: presets::TwoLiquids without a tension, start_hydrostatic in both; rho c^2 of both is 200 rho g h.
// Measure: at t = 3 the greatest error of the pressure of either over rho g h of the lower one, and the greatest speed
// of the lower one over sqrt(g h).
#pragma once

#include "case.hpp"

#include <imbibe/core/error.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/presets/two_liquids.hpp>
#include <imbibe/state/hydrostatic.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace validation::still_layers {

namespace sph = imbibe;
using Preset = sph::presets::TwoLiquids;

constexpr double heavier = 1000, kinematic = 0.01;

/// How far the layers are from rest.
struct Layers {
    double pressure = 0; ///< the greatest error, over rho g h
    double speed = 0;    ///< the greatest, over sqrt(g h)
};

/// With so many particles over a layer's height, the upper one of the density `lighter`.
inline Layers layers(double across, double lighter) {
    const double spacing = 1 / across, stiffness = 200 * heavier;
    Preset::Scene<2, double> scene(
        {.gravity = {0, -1}, .support_radius = 3 * spacing, .cfl = 0.4, .periodic_length = {1, 0}, .threads = 1});
    Preset::Water below{
        {.density = heavier, .sound_speed = std::sqrt(stiffness / heavier), .viscosity = heavier * kinematic}};
    Preset::Oil above{
        {.density = lighter, .sound_speed = std::sqrt(stiffness / lighter), .viscosity = lighter * kinematic}};
    const auto lower = scene.add(below, sph::fill(sph::Box<2>({0, 0}, {1, 1}), spacing), spacing);
    const auto upper = scene.add(above, sph::fill(sph::Box<2>({0, 1}, {1, 2}), spacing), spacing);
    scene.add(Preset::Vessel{{.density = heavier, .viscosity = heavier * kinematic}},
              sph::tank(sph::Box<2>({0, 0}, {1, 2}), spacing, 4, sph::Sides::x), spacing);
    sph::start_hydrostatic(scene, upper, 2);
    sph::start_hydrostatic(scene, lower, 1, lighter);
    scene.run_until(3);
    Layers seen;
    const auto look = [&](const auto& view, double density, double surface, double on_it) {
        for (int i = 0; i < view.size(); ++i) {
            const double right = on_it + density * (surface - view[sph::position](i, 1));
            seen.pressure = std::max(seen.pressure, std::abs(view[sph::pressure](i) - right) / heavier);
        }
    };
    look(scene[lower], heavier, 1, lighter);
    look(scene[upper], lighter, 2, 0);
    seen.speed = std::sqrt(scene[lower][sph::velocity].rowwise().squaredNorm().maxCoeff());
    return seen;
}

inline std::vector<Measured> measure(int across) {
    std::vector<Measured> found;
    for (const double lighter : {800.0, 1.0}) {
        const Layers seen = layers(across, lighter);
        found.push_back({sph::text("1 + error of the pressure, 1000 on ", lighter), "1 % at 40", 1 + seen.pressure, 1});
        found.push_back({sph::text("1 + greatest speed, 1000 on ", lighter), "1 %", 1 + seen.speed, 1});
    }
    return found;
}

} // namespace validation::still_layers
