// The distance from a wall's surface to the fluid that a wall particle sees.
#pragma once

#include <imbibe/core/lattice.hpp>
#include <imbibe/core/pack_functions.hpp>

namespace imbibe {

/// d = d_1 + s (D - D_1), m: the distance from the surface of a wall to the fluid that a wall particle sees, where D =
/// |sum_f (x_f - x_a) W_af| / sum_f W_af is the distance from the particle to that fluid. The numbers come from the
/// lattice of a scene: exact for the first two layers behind a plane face along it (0.50 to 0.58 spacings with supports
/// of 2 to 3), linear in D. A value that is u in the fluid and u_w at the surface is extrapolated linearly to u_w -
/// (D/d - 1) (u - u_w) at the particle.
///
/// Source: own; distances to a known surface, Morris, Fox and Zhu (1997), section 3.5.
struct SurfaceDistance {
    double to_surface = 1, offset = 1; ///< d_1 and D_1, of the first layer, m
    double slope = 0;                  ///< s, from there to the second

    /// d, m; not below a quarter of d_1. @param D m
    IMBIBE_INLINE constexpr auto of(const auto& D) const {
        return max(to_surface + slope * (D - offset), 0.25 * to_surface);
    }

    /// Of a plane face along the lattice, half a spacing before the first layer of the wall.
    template <class Kernel, int dim>
    static SurfaceDistance on(const Lattice<dim>& lattice) {
        const auto mean_offset = [&](double layer) { // of the fluid, from a layer of the wall; 0: no fluid in reach
            const auto sum = [&](int power_of_offset) {
                return lattice.sum([&](const auto& ab) {
                    const double x = ab.offset[0];
                    return x < (layer + 0.5) * lattice.spacing ? 0.0
                                                               : ab.value(Kernel{}) * (power_of_offset == 1 ? x : 1.0);
                });
            };
            const double weight = sum(0);
            return weight > 0 ? sum(1) / weight : 0.0;
        };
        const double first = mean_offset(0), second = mean_offset(1), spacing = lattice.spacing;
        if (!(first > 0))
            return {0.5 * spacing, spacing, 0};
        const double slope = second > first ? 1 - spacing / (second - first) : 0;
        return {first - 0.5 * spacing, first, slope};
    }
};

} // namespace imbibe
