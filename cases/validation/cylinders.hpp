// Creeping flow through a square array of cylinders, driven by a body force.
//
// Reference: Sangani and Acrivos (1982), the drag of a cylinder F/(mu U) for solid fractions c, with U averaged over
// the whole cell; for a radius of 0.2 L a boundary integral solution. The array conducts alike in all directions.
// Geometry: one cell of side L, periodic, with the cylinder in it; fluid and cylinder share one square lattice. Where
// its centre lies between the lattice's points is chosen so that the cylinder takes its share c of them.
// Scheme: that of creeping.hpp. L and nu are 1 and sound is 100 nu/L: its step is then about as long as that of
// viscosity, H/dx = 3, L/dx = 50.
// Measure: F/(mu U) = rho f L^2/(mu U), once U has stopped growing; Re = U L/nu is below 0.01.
#pragma once

#include "creeping.hpp"

#include <imbibe/geometry/jitter.hpp>

#include <cstdint>
#include <numbers>

namespace validation::cylinders {

/// What a run shows.
struct Flow {
    double drag;             ///< F/(mu U)
    double pair_evaluations; ///< the work, see imbibe::accuracy
};

/// What may be varied beside the fineness.
struct Numerics {
    double support = 3;     ///< in spacings
    double cfl = 0.4;       ///< share of the shortest limit that a step takes
    double jitter = 0;      ///< how far the liquid's particles begin off their lattice, spacings
    std::uint64_t seed = 0; ///< of the jitter
};

/// F/(mu U) for a solid fraction c, with the force at an angle to the rows of cylinders.
/// @tparam K the kernel
template <class K = sph::QuinticSpline, class Real = double>
Flow flow(int across, double fraction, double degrees = 0, const Numerics& with = {}) {
    const double spacing = 1.0 / across, force = 0.1, angle = degrees * std::numbers::pi / 180;
    const double radius = std::sqrt(fraction / std::numbers::pi);
    const sph::Point<2> cell(1, 1), along(std::cos(angle), std::sin(angle));
    auto parts = creeping::part<2>(sph::fill(sph::Box<2>{{0, 0}, cell}, spacing), spacing, cell / 2, fraction,
                                   [&](const auto& x) { return x.norm() < radius; });
    parts.liquid = sph::jitter(parts.liquid, with.jitter * spacing, with.seed);
    auto scene = creeping::scene_of<K, Real, 2>(parts, cell, force * along, spacing, with.support, 100, 1, with.cfl);
    // The slowest to start is the thinnest array, with about exp(-15 t): what is missing at the end is below 0.1 %.
    const double U = creeping::steady_flux<K>(scene, along, spacing, 0.02);
    return {force / U, sph::accuracy::pair_evaluations(scene)};
}

struct Known {
    double fraction, drag;
    const char* name;
};
inline constexpr Known known[]{{.05, 15.56, "c = 0.05"},
                                {.10, 24.83, "c = 0.10"},
                                {.20, 51.53, "c = 0.20"},
                                {.30, 102.90, "c = 0.30"},
                                {.04 * std::numbers::pi, 30.359, "radius 0.2 L"}};

inline std::vector<Measured> measure(int across) {
    std::vector<Measured> found;
    for (const Known& a : known)
        found.push_back({sph::text("F/(mu U), ", a.name), "3 % at 50", flow(across, a.fraction).drag, a.drag});
    found.push_back({"F/(mu U), c = 0.20, driven at 45 degrees", "3 % at 50", flow(across, .20, 45).drag, 51.53});
    return found;
}

} // namespace validation::cylinders
