// Hooke's law for the deviatoric stress as a rate, in axes that rotate with the material.
#pragma once

#include <imbibe/core/term.hpp>
#include <imbibe/solid/shear_energy.hpp>

namespace imbibe {

/// dS/dt = 2 G (e - tr(e)/3 1) + S Omega^T + Omega S, in Pa/s, with the rate of deformation
/// e_ij = (dv_i/dx_j + dv_j/dx_i)/2 and the spin Omega_ij = (dv_i/dx_j - dv_j/dx_i)/2.
///
/// The elastic solid of the paper, with an equation of state for the pressure. The Jaumann rate turns the stress with
/// the spin, so a rigid rotation creates none. In two dimensions this is plane strain: the trace is still divided by
/// 3, and S_zz = -(S_xx + S_yy) is not stored.
///
/// Not for Poisson's ratios near 0.5, where the mean stress alternates from particle to particle (the bound of 0.495 is
/// that of CompressibleNeoHookean).
///
/// Not for large shear: in simple shear the stress oscillates, S_xy = G sin(shear), and a closed cycle of strain leaves
/// a residual stress. Not for long runs that must return to their shape: errors of the rate accumulate in S. A
/// total-Lagrangian solid has neither fault.
///
/// Source: Gray, Monaghan and Swift (2001); the paper, Eqs. (5) to (7), where the trace is printed as
/// (1/3) delta_ij e_ij (it must be e_kk), and the sum over k covers both spin terms.
struct JaumannStress {
    using effect = effects::stress_rate;
    static constexpr bool of_solids = true;
    static constexpr double greatest_poisson_ratio = 0.495;
    using reads = Fields<velocity_gradient, deviatoric_stress>;
    using adds = Fields<deviatoric_stress_rate>;
    using reductions = Parts<ShearEnergy>;
    static constexpr bool in_packs = true;

    IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
        using A = std::remove_cvref_t<decltype(a)>;
        constexpr int dim = A::dimension;
        const auto gradient = a[velocity_gradient];
        const auto e = symmetric_part(gradient);
        const auto Omega = antisymmetric_part(gradient);
        const auto S = full(a[deviatoric_stress]);
        const auto unit = symmetric_identity<typename A::Scalar, dim>();
        return 2 * a.material.shear_modulus * (e - trace(e) / 3 * unit) +
               symmetric_part(S * transpose(Omega) + Omega * S);
    }
};

} // namespace imbibe
