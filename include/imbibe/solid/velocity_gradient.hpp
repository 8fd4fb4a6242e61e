// The velocity gradient: how fast the neighbourhood of a particle deforms and rotates.
#pragma once

#include <imbibe/core/term.hpp>

namespace imbibe {

/// dv_i/dx_j = - sum_b (m_b/rho_b) (v_a - v_b)_i dW_ab/dx_j, in 1/s; component (i, j) is dv_i/dx_j.
///
/// What JaumannStress works from. Zero for a uniform velocity with any arrangement of particles. `velocity_field` is
/// the velocity of which it is the gradient: `velocity`, or `smoothed_velocity` with Xsph.
///
/// Not exact for a linear velocity: with few neighbours and at a free surface it is too small (the factor is 0.47 in
/// the interior with 6 neighbours), and so is every stress computed from it. Where that matters take
/// CorrectedVelocityGradient (solid/corrected_gradients.hpp).
///
/// Source: Monaghan (1992); the paper, Eq. (21).
template <class Kernel, auto velocity_field = velocity>
struct VelocityGradient {
    using effect = effects::velocity_gradient;
    using reads = Fields<mass, density, velocity_field>;
    using adds = Fields<velocity_gradient>;

    IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        // v_a - v_b, which other terms of the sweep have, too
        return outer(-(b[mass] / b[density] * ab.gradient(Kernel{})) * (a[velocity_field] - b[velocity_field]),
                     ab.offset);
    }
};

} // namespace imbibe
