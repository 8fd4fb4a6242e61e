// The permeability of a simple cubic array of spheres, by permeability(), with fitted particles and two spacings.
//
// Reference: Zick and Homsy (1982), k = L^3/(6 pi a K) for spheres of radius a in cells of side L, at solid fractions
// c. Geometry: one cell, periodic, with the sphere in its middle; liquid and sphere are packed together. Scheme: that
// of porous/permeability.hpp, in float, H/dx = 3, at the spacing and at one about 1.5 times as wide. Measure: K from
// the extrapolated k.
#pragma once

#include "spheres.hpp"

#include <imbibe/geometry/sphere.hpp>
#include <imbibe/porous/permeability.hpp>

#include <numbers>

namespace validation::porous_spheres {

namespace sph = imbibe;

/// A sphere in a cell of side 1.
struct InCell {
    sph::Sphere<3> sphere;
    bool contains(const sph::Point<3>& x) const { return sphere.contains(x) && bounds().contains(x); }
    sph::Box<3> bounds() const { return {{0, 0, 0}, {1, 1, 1}}; }
};

inline std::vector<Measured> measure(int across) {
    std::vector<Measured> found;
    for (const auto& a : spheres::known) {
        const double radius = std::cbrt(3 * a.fraction / (4 * std::numbers::pi));
        const auto k = sph::permeability(InCell{sph::Sphere<3>{{0.5, 0.5, 0.5}, radius}}, 1.0 / across, 0,
                                         {.left = 5e-3, .threads = 1});
        found.push_back(
            {sph::text("K, c = ", a.fraction), "3 % at 16", 1 / (6 * std::numbers::pi * radius * k.column[0]), a.K});
    }
    return found;
}

} // namespace validation::porous_spheres
