// Creeping flow through a simple cubic array of spheres, driven by a body force.
//
// Reference: Zick and Homsy (1982), the drag F = 6 pi mu a K U of a sphere of radius a, for solid fractions c, with
// U averaged over the whole cell. Of spheres that touch also Kozeny and Carman's permeability of packings, e^3
// d^2/(180 (1 - e)^2) with the porosity e = 1 - c and the diameter d; Zick and Homsy's array has 1.15 times that.
// Geometry: one cell of side L, periodic, with the sphere in it; liquid and sphere share one cubic lattice. Where
// the sphere's centre lies between the lattice's points is chosen so that it takes its share c of them.
// Scheme: that of creeping.hpp. L and nu are 1 and sound is 60 nu/L: its step is then about as long as that of
// viscosity, H/dx = 3, L/dx = 32.
// Measure: K = rho f L^3/(6 pi mu a U), once U has stopped growing; Re = U L/nu is below 0.01.
#pragma once

#include "creeping.hpp"

#include <numbers>

namespace validation::spheres {

/// K for a solid fraction c. @param support in spacings
template <class K = sph::QuinticSpline, class Real = double>
double drag(int across, double fraction, double support = 3) {
    const double spacing = 1.0 / across, force = 0.1;
    const double radius = std::cbrt(3 * fraction / (4 * std::numbers::pi));
    const sph::Point<3> cell(1, 1, 1), along(0, 0, 1);
    const auto parts = creeping::part<3>(sph::fill(sph::Box<3>{{0, 0, 0}, cell}, spacing), spacing, cell / 2, fraction,
                                         [&](const auto& x) { return x.norm() < radius; });
    auto scene = creeping::scene_of<K, Real, 3>(parts, cell, force * along, spacing, support, 60);
    // The thinnest array is the slowest to start, with about exp(-10 t): what is missing at the end is below 0.2 %.
    const double U = creeping::steady_flux<K>(scene, along, spacing, 0.02);
    return force / (6 * std::numbers::pi * radius * U);
}

struct Known {
    double fraction, K;
};
/// Zick and Homsy (1982); the last ones touch.
inline constexpr Known known[]{{.027, 2.008}, {.064, 2.810}, {.125, 4.292}, {.216, 7.442},
                               {.343, 15.4},  {.45, 28.1},   {.5236, 42.1}};

inline std::vector<Measured> measure(int across) {
    std::vector<Measured> found;
    double touching = 0;
    for (const Known& a : known) {
        touching = drag(across, a.fraction);
        found.push_back({sph::text("K, c = ", a.fraction), "8 % at 24 to 32", touching, a.K});
    }
    const double c = .5236, porosity = 1 - c; // with d: U = rho f L^3/(6 pi mu a K) = rho f d^2/(18 c K)/mu
    found.push_back({"permeability in d^2, spheres that touch, beside Kozeny and Carman", "none given",
                     1 / (18 * c * touching), porosity * porosity * porosity / (180 * c * c)});
    return found;
}

} // namespace validation::spheres
