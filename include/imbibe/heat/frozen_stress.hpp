// Ice as a soft elastic solid, in the same phase as the water.
#pragma once

#include <imbibe/core/phase.hpp>
#include <imbibe/fluid/volume.hpp>
#include <imbibe/heat/melting.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/solid/velocity_gradient.hpp>
#include <imbibe/state/wave_speed.hpp>

#include <cmath>
#include <string_view>
#include <type_traits>

namespace imbibe {

/// Coefficients of FrozenStress.
struct FrozenStressParameters {
    double shear_modulus = required; ///< G of what is frozen, Pa: ice has 3.5e9; as soft as the scene bears, below rho
                                     ///< c^2, makes longer steps

    /// Throws Error for a number out of range. @param where the phase in the message
    void check(std::string_view where) const {
        detail::require_heat_number(shear_modulus, where, "FrozenStressParameters::shear_modulus", "Pa",
                                    "below rho c^2, so that it does not limit the step");
    }
};

/// dS/dt = (1 - f) (2 G (e - tr(e)/3 1) + S Omega^T + Omega S) - f S/dt, in Pa/s, with the liquid fraction f, the rate
/// of deformation e and the spin Omega of the VelocityGradient, and the length dt of the step; and its force, dv_a/dt =
/// 1/m_a sum_b V_a V_b (S_a + S_b) grad_a W_ab, in m/s^2. This is JaumannStress in frozen fluid and no stress in
/// liquid; in mush the stress decays in a few steps. Freezing fluid starts stress-free.
///
/// In a fluid beside Melting and VelocityGradient: ice that bends, floats, and is held to walls and solids by
/// FrozenDrag in the couplings.
///
/// Not for ice with large rotation or shear (see JaumannStress), nor for breaking ice. Not with integrators of several
/// stages, whose terms do not see the length of a step: melting fluid would keep its stress.
///
/// Source: Gray, Monaghan and Swift (2001) for the rate; the weighting with the frozen share, own.
template <class Kernel = WendlandC2>
struct FrozenStress : NotStiff { // has a limit of its own, that of sound
    using Parameters = FrozenStressParameters;
    static constexpr bool within_phases = true;
    struct Stretch {
        using reads = Fields<velocity_gradient, deviatoric_stress, liquid_fraction>;
        using adds = Fields<deviatoric_stress_rate>;
        static constexpr bool in_packs = true;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            using A = std::remove_cvref_t<decltype(a)>;
            const auto gradient = a[velocity_gradient];
            const auto e = symmetric_part(gradient);
            const auto Omega = antisymmetric_part(gradient);
            const auto S = full(a[deviatoric_stress]);
            const auto unit = symmetric_identity<typename A::Scalar, A::dimension>();
            const auto f = a[liquid_fraction];
            const double fading = a.time_step > 0 ? 1 / a.time_step : 0;
            return (1 - f) * (2 * parameters.shear_modulus * (e - trace(e) / 3 * unit) +
                              symmetric_part(S * transpose(Omega) + Omega * S)) -
                   (fading * f) * a[deviatoric_stress];
        }
    };
    struct Pull {
        using reads = Fields<mass, volume, deviatoric_stress>;
        using adds = Fields<acceleration>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            return (a[volume] * b[volume] / a[mass] * ab.gradient(Kernel{})) *
                   ((a[deviatoric_stress] + b[deviatoric_stress]) * ab.offset);
        }
    };
    using parts = Parts<Volume, Stretch, Pull>;

    static constexpr const char* limit_name = "sound in ice";
    /// max(spacing, 0.6 H)/(sqrt(c^2 + 4 G/(3 rho)) + v), s, see acoustic_time_step.
    static double time_step_limit(const auto& material, const TimeStepInput& in, const Parameters& parameters) {
        const double speed = std::sqrt(material.sound_speed * material.sound_speed +
                                       4 * parameters.shear_modulus / (3 * material.density));
        return acoustic_time_step(speed, in);
    }
};

} // namespace imbibe
