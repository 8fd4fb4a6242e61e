// The elastic force of a total-Lagrangian solid.
#pragma once

#include <imbibe/solid/first_piola.hpp>
#include <imbibe/solid/reference_correction.hpp>

namespace imbibe {

/// s P L/rho_0^2, Pa m^6/kg^2: the stress with its correction, ready for the sum over pairs.
struct CorrectedPiolaStress : Field<Rank::tensor> {
    static constexpr std::string_view name = "corrected_piola_stress", unit = "Pa m^6/kg^2";
};
inline constexpr CorrectedPiolaStress corrected_piola_stress{};

/// dv_a/dt = sum_b m_b (s_a P_a L_a/rho_0a^2 + s_b P_b L_b/rho_0b^2) grad_a W_ab, in m/s^2, over the neighbours and
/// with the kernel of the stress-free solid; P is the first Piola-Kirchhoff stress, L and s are the correction and the
/// stress share of ReferenceCorrection (s is 1 except in the thinnest parts).
///
/// It is minus the derivative of the elastic energy sum_a s_a V_a psi(F_a) with respect to x_a, with F_a of
/// DeformationGradient: differentiating F_a gives V_b L_a grad_a W_ab, once from a's own F and once from each
/// neighbour's, and grad_a W_ab = -grad_b W_ba. So linear momentum is conserved to round-off pair by pair (to the last
/// bit for equal masses), energy in the sum, and angular momentum in the sum where L is the inverse of M or s is 0.
/// There is no clumping under any stretch, because the kernel uses stress-free distances.
///
/// Not without HourglassControl where the solid bends or is hit: motions that alternate from particle to particle do
/// not change F and are not resisted. Not for solids that flow or break. It does not act between bodies of the phase
/// that meet: that needs another term (solid/total_lagrangian.hpp).
///
/// Source: Bonet and Kulasegaram (2002); Vignjevic, Reveles and Campbell (2006); Ganzenmueller (2015).
template <class Kernel = WendlandC2>
struct TotalLagrangianForce {
    using effect = effects::pressure_force;
    using corrected_kernel = Kernel;
    struct Prepare {
        using reads = Fields<first_piola_stress, gradient_correction, stress_share>;
        using sets = Fields<corrected_piola_stress>;
        static constexpr bool in_packs = true;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            using T = typename std::remove_cvref_t<decltype(a)>::Scalar;
            return (T(1 / sq(a.material.density)) * a[stress_share]) *
                   (a[first_piola_stress] * full(a[gradient_correction]));
        }
    };
    struct Push {
        using neighbourhood = Reference;
        using reads = Fields<mass, corrected_piola_stress>;
        using adds = Fields<acceleration>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            return (b[mass] * ab.gradient(Kernel{})) *
                   ((a[corrected_piola_stress] + b[corrected_piola_stress]) * ab.offset);
        }
    };
    using parts = Parts<Prepare, Push>;
};

} // namespace imbibe
