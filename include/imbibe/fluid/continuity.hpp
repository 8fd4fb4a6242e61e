// The continuity equation: how the density of a particle changes as its neighbours come and go.
#pragma once

#include <imbibe/core/term.hpp>
#include <imbibe/fluid/volume.hpp>
#include <imbibe/state/wave_speed.hpp>

namespace imbibe {

/// drho_a/dt = sum_b m_b (v_a - v_b) . grad_a W_ab, in kg/m^3/s.
///
/// For one phase, fluid or solid. The volume it implies for a neighbour is m_b/rho_a, so the sum is exactly the rate
/// of the density by summation; it needs no special care at a free surface.
/// `velocity_field` is the velocity that the density follows: `velocity`, or `smoothed_velocity` with Xsph.
///
/// Not across phases with different densities or particle volumes: there it underrates the approach of a light
/// neighbour and overrates that of a heavy one; see VolumeContinuity. The paper, Eq. (22), does use it there.
///
/// Source: Monaghan (1994); the paper, Eqs. (11) and (22).
template <class Kernel, auto velocity_field = velocity>
struct Continuity {
    using effect = effects::continuity_equation;
    using reads = Fields<mass, velocity_field>;
    using adds = Fields<density_rate>;

    IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        return (b[mass] * ab.gradient(Kernel{})) * dot(a[velocity_field] - b[velocity_field], ab.offset);
    }

    static constexpr const char* limit_name = "pressure between phases";
    /// In a coupling: that of mass_weighted_interface_time_step, s.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in) {
        return mass_weighted_interface_time_step(material_a, material_b, in);
    }
};

/// drho_a/dt = rho_a sum_b (m_b/rho_b) (v_a - v_b) . grad_a W_ab, in kg/m^3/s.
///
/// The rate of compression by volumes: it counts the volume that the neighbour sweeps, not its mass. The form for
/// couplings, where densities and particle volumes differ, and for fluids with a density jump.
///
/// Volumes are those of Volume, which VolumePressure and DensityDiffusion share. In a coupling under `Into<Water, ...>`
/// the other phase needs a volume too: from VolumePressure without `Into`, or from Volume among its terms.
///
/// Not where the density must stay the sum of the masses around a particle to the last digit: over a long run this
/// form drifts from it. Not beside SymmetricPressure between phases whose densities differ by more than a factor of two
/// (see there).
///
/// Source: Colagrossi and Landrini (2003); the paper, Eq. (22), in the form that is consistent across phases.
template <class Kernel, auto velocity_field = velocity>
struct VolumeContinuity {
    using effect = effects::continuity_equation;
    struct Sweep {
        using reads = Fields<density, volume, velocity_field>;
        using adds = Fields<density_rate>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            return a[density] * b[volume] * dot(a[velocity_field] - b[velocity_field], ab.offset) *
                   ab.gradient(Kernel{});
        }
    };
    using parts = Parts<Volume, Sweep>;
};

} // namespace imbibe
