// The force of the stress in a solid: the divergence of the Cauchy stress, pair by pair.
#pragma once

#include <imbibe/core/term.hpp>

namespace imbibe {

/// sigma/rho^2 with the Cauchy stress sigma = S - p 1, Pa m^6/kg^2: what StressForce prepares once per particle.
struct StressOverDensity2 : Field<Rank::symmetric_tensor> {
    static constexpr std::string_view name = "stress_over_density2", unit = "Pa m^6/kg^2";
};
inline constexpr StressOverDensity2 stress_over_density2{};

/// dv_a/dt = sum_b m_b (sigma_a/rho_a^2 + sigma_b/rho_b^2) grad_a W_ab, in m/s^2, with the Cauchy stress sigma = S - p
/// 1 (tension is positive). It includes the pressure: a phase with StressForce takes no SymmetricPressure of its own (a
/// Coupling may still have one).
///
/// The force of the pair is equal and opposite, to the last bit where the masses are equal.
///
/// Not without ArtificialStress where the solid is stretched: tension makes the particles clump. The forces are not
/// central: angular momentum is conserved only as well as the gradients allow.
///
/// Source: Gray, Monaghan and Swift (2001); the paper, Eqs. (4) and (15).
template <class Kernel>
struct StressForce {
    using effect = effects::pressure_force;
    struct Prepare {
        using reads = Fields<density, pressure, deviatoric_stress>;
        using sets = Fields<stress_over_density2>;
        static constexpr bool in_packs = true;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            using A = std::remove_cvref_t<decltype(a)>;
            const auto unit = symmetric_identity<typename A::Scalar, A::dimension>();
            return (a[deviatoric_stress] - a[pressure] * unit) / sq(a[density]);
        }
    };
    struct Push {
        using reads = Fields<mass, stress_over_density2>;
        using adds = Fields<acceleration>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            return (b[mass] * ab.gradient(Kernel{})) *
                   ((a[stress_over_density2] + b[stress_over_density2]) * ab.offset);
        }
    };
    using parts = Parts<Prepare, Push>;
};

} // namespace imbibe
