// The pressure gradient in the form that conserves momentum pair by pair.
#pragma once

#include <imbibe/core/term.hpp>
#include <imbibe/state/wave_speed.hpp>

namespace imbibe {

/// p/rho^2, Pa m^6/kg^2: what SymmetricPressure prepares once per particle.
struct PressureOverDensity2 : Field<Rank::scalar> {
    static constexpr std::string_view name = "pressure_over_density2", unit = "Pa m^6/kg^2";
};
inline constexpr PressureOverDensity2 pressure_over_density2{};

/// dv_a/dt = - sum_b m_b (p_a/rho_a^2 + p_b/rho_b^2) grad_a W_ab, in m/s^2.
///
/// For a fluid of one density, and in a Coupling for the pressure between fluid and solid as the paper has it. The
/// force of the pair is - m_a m_b (p_a/rho_a^2 + p_b/rho_b^2) grad_a W_ab: along the line of centres, equal and
/// opposite, to the last bit where the masses are equal.
///
/// Not for interfaces with a large density jump, where it acts as a surface tension: see VolumePressure. Not in a
/// coupling beside VolumeContinuity where densities differ by more than a factor of two: the work of the force does not
/// match the compression counted, and energy grows however short the steps are (water at rest on a fluid or solid of
/// 200 kg/m^3). Continuity is the counterpart of this force, VolumeContinuity that of VolumePressure. A uniform
/// pressure on disordered particles still pushes them (towards order), and a negative one pulls them into clumps. Use a
/// kernel whose slope does not vanish at the centre (Spiky) or one that does not pair (Wendland).
///
/// Source: Monaghan (1992), Eq. 3.3; the paper, Eq. (12), and Eq. (23) without its extra rho_b, which broke the balance
/// of action and reaction.
template <class Kernel>
struct SymmetricPressure {
    using effect = effects::pressure_force;
    using pressure_kernel = Kernel;
    struct Prepare {
        using reads = Fields<density, pressure>;
        using sets = Fields<pressure_over_density2>;
        static constexpr bool in_packs = true;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const { return a[pressure] / sq(a[density]); }
    };
    struct Push {
        using reads = Fields<mass, pressure_over_density2>;
        using adds = Fields<acceleration>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            return along(
                ab, -((b[mass] * ab.gradient(Kernel{})) * (a[pressure_over_density2] + b[pressure_over_density2])));
        }
    };
    using parts = Parts<Prepare, Push>;

    static constexpr const char* limit_name = "pressure between phases";
    /// In a coupling: that of mass_weighted_interface_time_step, s.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in) {
        return mass_weighted_interface_time_step(material_a, material_b, in);
    }
};

} // namespace imbibe
