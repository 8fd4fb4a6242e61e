// A compressible neo-Hookean solid: rubber, and foams that are squeezed hard.
#pragma once

#include <imbibe/solid/first_piola.hpp>

namespace imbibe {

/// P = mu (F - F^-T) + lambda/2 (J^2 - 1) F^-T, in Pa, J = det F, with mu = G and lambda = K - 2G/3, K = rho_0 c^2 of
/// the material. In 2D: plane strain (the third stretch is one).
///
/// For large strains, above all compression, which it resists without limit. Equal to Hooke's law for small ones.
///
/// Not for Poisson's ratios near 0.5: the mean stress then alternates from particle to particle; VolumetricDeviatoric
/// averages it.
///
/// An element turned inside out (J <= 0) is beyond it; J is then taken as 0.001, which pushes it back.
///
/// Source: Ciarlet (1988); Simo and Hughes (1998).
struct NeoHookean {
    static constexpr bool of_solids = true;
    static constexpr double greatest_poisson_ratio = 0.495;
    using reads = Fields<deformation_gradient>;
    using sets = Fields<first_piola_stress>;
    static constexpr bool in_packs = true;

    IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
        using T = typename std::remove_cvref_t<decltype(a)>::Scalar;
        const auto F = a[deformation_gradient];
        const T J = max(determinant(F), T(1e-3));
        const auto cofactor = transpose(adjugate(F)); // J F^-T
        const T mu = a.material.shear_modulus, lambda = detail::lame_lambda(a.material);
        return mu * F + ((T(0.5) * lambda * (sq(J) - 1) - mu) / J) * cofactor;
    }

    /// The energy stored by the deformation F, J/m^3 of the stress-free solid:
    /// lambda/4 (J^2 - 1 - 2 ln J) + mu/2 (tr F^T F - dim - 2 ln J), J as above.
    template <int dim>
    static double stored_energy(const auto& material, const Tensor<double, dim>& F) {
        const double J = std::max(determinant(F), 1e-3), log = std::log(J);
        return 0.25 * detail::lame_lambda(material) * (sq(J) - 1 - 2 * log) +
               0.5 * material.shear_modulus * (trace(transpose(F) * F) - dim - 2 * log);
    }

    /// (c/c_0)^2 at the deformation F or a little more: the square of the fastest wave's speed over that of the
    /// stress-free solid. The acoustic tensor of a wave with the stress-free normal N is mu 1 + (lambda/2 (J^2 + 1) +
    /// mu) m (x) m, m = F^-T N, Pa; |m|^2 is at most the greatest eigenvalue of (F^T F)^-1, of which there is a bound
    /// (detail::greatest_row_sum).
    template <class T, int n>
    static constexpr T wave_stiffening(const auto& material, const Tensor<T, n>& F) {
        const T J = max(determinant(F), T(1e-3));
        const auto inverse_times_J = adjugate(F);
        const T m2 = detail::greatest_row_sum(inverse_times_J * transpose(inverse_times_J)) / sq(J);
        const T mu = material.shear_modulus, lambda = detail::lame_lambda(material);
        return (mu + (T(0.5) * lambda * (sq(J) + 1) + mu) * m2) / (lambda + 2 * mu);
    }

    static constexpr const char* limit_name = "elastic wave";
    /// That of StVenantKirchhoff, s.
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        return detail::elastic_wave_limit(material, in);
    }
};

} // namespace imbibe
