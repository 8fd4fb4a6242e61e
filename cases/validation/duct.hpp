// Steady flow in a square duct, driven by a body force.
//
// Reference: the series solution (White, Viscous Fluid Flow, 3-3.3): the mean velocity is 0.0351443 f a^2/nu in a
// duct of side a.
// Geometry: a and nu are 1; 8 spacings long and periodic, cubic lattice, four sides of wall.
// Scheme: that of creeping.hpp; sound is 40 nu/a, 540 times the greatest speed.
// Measure: the mean velocity, once it has stopped growing.
#pragma once

#include "creeping.hpp"

namespace validation::duct {

/// The mean velocity over f a^2/nu. @param across spacings in a side, @param support in spacings
template <class K = sph::QuinticSpline, class Real = double>
double mean_velocity(int across, double support = 3) {
    const double spacing = 1.0 / across, length = 8 * spacing, force = 1;
    const sph::Box<3> inside{{0, 0, 0}, {length, 1, 1}};
    const creeping::Parts<3> parts{sph::fill(inside, spacing),
                                   sph::tank(inside, spacing, static_cast<int>(std::ceil(support)), sph::Sides::x)};
    auto scene = creeping::scene_of<K, Real, 3>(parts, {length, 0, 0}, {force, 0, 0}, spacing, support, 40);
    // It starts with about exp(-20 t).
    return creeping::steady_flux<K>(scene, sph::Point<3>(1, 0, 0), spacing, 0.05) / length / force;
}

inline std::vector<Measured> measure(int across) {
    return {{"mean velocity, f a^2/nu", "2 %", mean_velocity(across), 0.0351443}};
}

} // namespace validation::duct
