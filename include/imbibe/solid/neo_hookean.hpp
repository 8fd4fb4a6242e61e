// Neo-Hookean solids, W = G/2 (tr C - 3) plus a volumetric energy: rubber, and strongly compressed foams.
//
//     CompressibleNeoHookean   W = G/2 (tr C - 3 - 2 ln J)     + lambda/4 (J^2 - 1 - 2 ln J)
//     IsochoricNeoHookean      W = G/2 (J^(-2/3) tr C - 3)     + K/4      (J^2 - 1 - 2 ln J)
#pragma once

#include <imbibe/solid/elastic_energy.hpp>
#include <imbibe/solid/first_piola.hpp>

namespace imbibe {

/// W = G/2 (tr C - 3 - 2 ln J) + lambda/4 (J^2 - 1 - 2 ln J), the energy stored in J/m^3 of the stress-free solid, with
/// C = F^T F, J = det F and lambda = K - 2G/3, K = rho_0 c^2 of the material. In 2D: plane strain, the third stretch is
/// one and counts in tr C. The stress is
///
///     P = dW/dF = G (F - F^-T) + lambda/2 (J^2 - 1) F^-T, in Pa.
///
/// One of two laws called neo-Hookean: here tr C includes the volume as well as the shape; IsochoricNeoHookean
/// separates them. Both are Hooke's law for small strains, and differ for large ones, the more so the more compressible
/// the solid is: with lateral strain zero and Poisson's ratio 0.3, the stress here is less by 6 % at a stretch of 0.8
/// and greater by 10 % at 1.5 (by 1.9 % and 3 % with 0.45; tests/terms/test_neo_hookean.cpp). To reproduce the results
/// of a program, or use a constant from a paper, find out which of the two it has.
///
/// For large strains, above all compression, which it resists without limit.
///
/// Not for Poisson's ratios near 0.5: the mean stress then alternates from particle to particle; VolumetricDeviatoric
/// averages it.
///
/// An element turned inside out (J <= 0) is beyond it; J is then taken as 0.001, which pushes it back.
///
/// Source: Ciarlet (1988); Simo and Hughes (1998).
struct CompressibleNeoHookean {
    static constexpr bool of_solids = true;
    static constexpr double greatest_poisson_ratio = 0.495;
    using reads = Fields<deformation_gradient>;
    using sets = Fields<first_piola_stress>;
    using reductions = Parts<ElasticEnergy<CompressibleNeoHookean>>;
    static constexpr bool in_packs = true;

    IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
        using T = typename std::remove_cvref_t<decltype(a)>::Scalar;
        const auto F = a[deformation_gradient];
        const T J = max(determinant(F), T(1e-3));
        const auto cofactor = transpose(adjugate(F)); // J F^-T
        const T mu = a.material.shear_modulus, lambda = detail::lame_lambda(a.material);
        return mu * F + ((T(0.5) * lambda * (sq(J) - 1) - mu) / J) * cofactor;
    }

    /// W as above, J/m^3 of the stress-free solid.
    template <int dim>
    static double stored_energy(const auto& material, const Tensor<double, dim>& F) {
        const double J = std::max(determinant(F), 1e-3), log = std::log(J);
        return 0.25 * detail::lame_lambda(material) * (sq(J) - 1 - 2 * log) +
               0.5 * material.shear_modulus * (trace(transpose(F) * F) - dim - 2 * log);
    }

    /// (c/c_0)^2 at the deformation F or a little more: the square of the fastest wave's speed over that of the
    /// stress-free solid. The acoustic tensor of a wave with the stress-free normal N is mu 1 + (lambda/2 (J^2 + 1) +
    /// mu) m (x) m, m = F^-T N, mu = G, Pa; |m|^2 is at most the greatest eigenvalue of (F^T F)^-1, for which
    /// detail::greatest_row_sum is a bound.
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

namespace detail {
// dW/dF, Pa, of W = G/2 (J^(-2/3) tr C - 3) + U(J), with the mean stress U' = p, Pa, tension being positive.
template <class T, int n>
IMBIBE_INLINE constexpr Tensor<T, n> isochoric_stress(const Tensor<T, n>& F, T J, T G, T p) {
    const T I1 = trace(transpose(F) * F) + T(3 - n); // the third stretch of plane strain is one
    const T shear = G * pow(J, -2.0 / 3);
    return shear * F + (p - shear * I1 / (3 * J)) * transpose(adjugate(F)); // which is J F^-T
}
} // namespace detail

/// W = G/2 (J^(-2/3) tr C - 3) + K/4 (J^2 - 1 - 2 ln J), the energy stored in J/m^3 of the stress-free solid, with C =
/// F^T F, J = det F and K = rho_0 c^2 of the material. In 2D: plane strain, the third stretch is one and counts in tr
/// C. The stress is
///
///     P = dW/dF = G J^(-2/3) (F - tr C/3 F^-T) + K/2 (J^2 - 1) F^-T, in Pa.
///
/// The law with separate energies of shape (isochoric: J^(-2/3) C has the determinant one) and volume: shear gives no
/// pressure, a change of volume no shear stress. The other law of that name is CompressibleNeoHookean, which says how
/// much the two differ. VolumetricDeviatoric is this law with averaged volumes.
///
/// For large strains, and where G and K must keep their meaning at every strain.
///
/// Not for Poisson's ratios near 0.5: the mean stress then alternates from particle to particle; VolumetricDeviatoric
/// averages it.
///
/// An element turned inside out (J <= 0) is beyond it; J is then taken as 0.001, which pushes it back.
///
/// Source: Simo, Taylor and Pister (1985); Simo and Hughes (1998).
struct IsochoricNeoHookean {
    static constexpr bool of_solids = true;
    static constexpr double greatest_poisson_ratio = 0.495;
    using reads = Fields<deformation_gradient>;
    using sets = Fields<first_piola_stress>;
    using reductions = Parts<ElasticEnergy<IsochoricNeoHookean>>;
    static constexpr bool in_packs = true;

    IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
        using T = typename std::remove_cvref_t<decltype(a)>::Scalar;
        const auto F = a[deformation_gradient];
        const T J = max(determinant(F), T(1e-3));
        const T mean = T(0.5 * a.material.bulk_modulus()) * (J - 1 / J);
        return detail::isochoric_stress(F, J, T(a.material.shear_modulus), mean);
    }

    /// W as above, J/m^3 of the stress-free solid.
    template <int dim>
    static double stored_energy(const auto& material, const Tensor<double, dim>& F) {
        const double J = std::max(determinant(F), 1e-3), I1 = trace(transpose(F) * F) + (3 - dim);
        return 0.5 * material.shear_modulus * (I1 / sq(std::cbrt(J)) - 3) +
               0.25 * material.bulk_modulus() * (sq(J) - 1 - 2 * std::log(J));
    }

    /// (c/c_0)^2 at the deformation F or a little more: the square of the fastest wave's speed over that of the
    /// stress-free solid. The acoustic tensor of a wave with the stress-free normal N is G J^(-2/3) [1 - 2/3 (n (x) m +
    /// m (x) n) + 5/9 I_1 m (x) m] + K/2 (J^2 + 1) m (x) m, n = F N, m = F^-T N, n.m = 1, I_1 = tr C, Pa; |n|^2 and
    /// |m|^2 are at most the greatest eigenvalues of F^T F and its inverse, for which detail::greatest_row_sum gives
    /// bounds.
    template <class T, int n>
    static constexpr T wave_stiffening(const auto& material, const Tensor<T, n>& F) {
        const T J = max(determinant(F), T(1e-3));
        const auto inverse_times_J = adjugate(F);
        const auto C = transpose(F) * F;
        const T m2 = detail::greatest_row_sum(inverse_times_J * transpose(inverse_times_J)) / sq(J);
        const T n2 = detail::greatest_row_sum(C), I1 = trace(C) + T(3 - n);
        // the greater eigenvalue of -2/3 (n (x) m + m (x) n) + 5/9 I_1 m (x) m, in the plane of the two
        const T half = T(5.0 / 18) * I1 * m2 - T(2.0 / 3);
        const T both = half + sqrt(sq(half) + T(4.0 / 9) * positive_part(m2 * n2 - 1));
        const T G = material.shear_modulus, K = material.bulk_modulus();
        return (G * pow(J, -2.0 / 3) * (1 + both) + T(0.5) * K * (sq(J) + 1) * m2) / (K + T(4.0 / 3) * G);
    }

    static constexpr const char* limit_name = "elastic wave";
    /// That of StVenantKirchhoff, s.
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        return detail::elastic_wave_limit(material, in);
    }
};

} // namespace imbibe
