// The law of St. Venant and Kirchhoff, W = lambda/2 tr(E)^2 + G E:E: Hooke's law for large rotations.
#pragma once

#include <imbibe/solid/elastic_energy.hpp>
#include <imbibe/solid/first_piola.hpp>

namespace imbibe {

/// W = lambda/2 tr(E)^2 + G E:E, the energy stored in J/m^3 of the stress-free solid, with E = (F^T F - 1)/2 and lambda
/// = K - 2G/3, K = rho_0 c^2 of the material. In 2D: plane strain, E has no component out of the plane. The stress is
///
///     P = dW/dF = F S, S = lambda tr(E) 1 + 2 G E, in Pa.
///
/// For large displacements and rotations with small strains (plates, beams, sponges that bend): a rotation gives no
/// stress.
///
/// Not for strong compression: below a stretch of 0.58 the material softens and finally collapses (dP/dF < 0 for F <
/// 1/sqrt(3) in one dimension). The neo-Hookean laws do not.
///
/// Source: any textbook of continuum mechanics, for instance Holzapfel (2000).
struct StVenantKirchhoff {
    static constexpr bool of_solids = true;
    static constexpr double greatest_poisson_ratio = 0.495;
    using reads = Fields<deformation_gradient>;
    using sets = Fields<first_piola_stress>;
    using reductions = Parts<ElasticEnergy<StVenantKirchhoff>>;
    static constexpr bool in_packs = true;

    IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
        using A = std::remove_cvref_t<decltype(a)>;
        using T = typename A::Scalar;
        const auto F = a[deformation_gradient];
        const auto E = T(0.5) * (transpose(F) * F - identity<T, A::dimension>());
        const auto S = T(detail::lame_lambda(a.material)) * trace(E) * identity<T, A::dimension>() +
                       T(2 * a.material.shear_modulus) * E;
        return F * S;
    }

    /// W as above, J/m^3 of the stress-free solid.
    template <int dim>
    static double stored_energy(const auto& material, const Tensor<double, dim>& F) {
        const auto E = 0.5 * (transpose(F) * F - identity<double, dim>());
        return 0.5 * detail::lame_lambda(material) * sq(trace(E)) + material.shear_modulus * trace(E * E);
    }

    /// (c/c_0)^2 at the deformation F or a little more: the square of the fastest wave's speed over that of the
    /// stress-free solid. The acoustic tensor of a wave with the stress-free normal N is (N.S N) 1 + (lambda + G) n (x)
    /// n + G F F^T, n = F N, Pa; a bound of the greatest eigenvalue of F^T F (detail::greatest_row_sum) bounds each of
    /// the three.
    template <class T, int n>
    static constexpr T wave_stiffening(const auto& material, const Tensor<T, n>& F) {
        const auto C = transpose(F) * F;
        const T greatest = detail::greatest_row_sum(C);
        const T mu = material.shear_modulus, lambda = detail::lame_lambda(material);
        const T stress = T(0.5) * lambda * (trace(C) - n) + mu * (greatest - 1);
        return (stress + (lambda + 2 * mu) * greatest) / (lambda + 2 * mu);
    }

    static constexpr const char* limit_name = "elastic wave";
    /// f spacing/(c_l + v), s, with the speed of longitudinal waves c_l = sqrt((K + 4G/3)/rho_0), the greatest speed v
    /// in the phase, and f = 1 except for short supports and for Poisson's ratios near 1/2: with n = nu/(1 - nu) and r
    /// = H/spacing it is the least of 1, r/1.85 and sqrt(r/(1.2 + 1.5 n)), in 2D of 1 and sqrt(r/(0.9 + 1.1 n)).
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        return detail::elastic_wave_limit(material, in);
    }
};

} // namespace imbibe
