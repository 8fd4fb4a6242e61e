// A nearly incompressible rubber: the pressure from the change of volume averaged over the neighbours, the rest of the
// stress from the particle's own deformation.
#pragma once

#include <imbibe/kernels/poly6.hpp>
#include <imbibe/solid/deformation_gradient.hpp>
#include <imbibe/solid/first_piola.hpp>

namespace imbibe {

/// J = det F, the volume of a particle relative to that of the stress-free solid.
struct VolumeRatioField : Field<Rank::scalar> {
    static constexpr std::string_view name = "volume_ratio", unit = "1";
};
inline constexpr VolumeRatioField volume_ratio{};

/// sum_b V_b W_ab over the stress-free neighbours, the particle itself among them, without unit.
struct AverageWeight : Field<Rank::scalar> {
    static constexpr std::string_view name = "average_weight", unit = "1";
};
inline constexpr AverageWeight average_weight{};

/// sum_b V_b W_ab J_b, without unit.
struct VolumeRatioSum : Field<Rank::scalar> {
    static constexpr std::string_view name = "volume_ratio_sum", unit = "1";
};
inline constexpr VolumeRatioSum volume_ratio_sum{};

/// U'(mean J)/sum_b V_b W_ab, Pa: the mean stress of the averaged volume, ready to be shared out.
struct SharedMeanStress : Field<Rank::scalar> {
    static constexpr std::string_view name = "shared_mean_stress", unit = "Pa";
};
inline constexpr SharedMeanStress shared_mean_stress{};

/// sum_b V_b W_ab U'_b/(sum_c V_c W_bc), Pa: the mean stress of the particle. Tension is positive.
struct AveragedMeanStress : Field<Rank::scalar> {
    static constexpr std::string_view name = "averaged_mean_stress", unit = "Pa";
};
inline constexpr AveragedMeanStress averaged_mean_stress{};

/// P = G J^(-2/3) (F - I_1/3 F^-T) + p J F^-T, in Pa, for the stored energy, J,
///
///     sum_a V_a [G/2 (J_a^(-2/3) I_1a - 3) + U(mean J_a)],   U(J) = K/2 ((J^2 - 1)/2 - ln J),
///
/// with I_1 = tr F^T F (plus 1 in 2D: plane strain) and K = rho_0 c^2. The mean of J is the kernel average over the
/// stress-free neighbours, mean J_a = sum_b V_b W_ab J_b / sum_b V_b W_ab. The mean stress that belongs to it is
/// averaged back with the same weights turned round, p_a = sum_b V_b W_ab U'(mean J_b) / sum_c V_c W_bc: then the force
/// of TotalLagrangianForce is minus the derivative of the energy, and momentum, angular momentum and energy are kept as
/// with any other law.
///
/// A law in place of NeoHookean, for Poisson's ratios near 1/2. There the local volume asks more of the particles than
/// their neighbours leave them free to do, and the mean stress alternates from particle to particle (checkerboard).
/// Averaged, it is smooth: where J alternates on a square lattice with a support of 2 spacings, 0.06 of that is left in
/// mean J, and 0.06 of that again in the mean stress. In a swinging beam (nu 0.499) the alternating part of the mean
/// stress fell to 1/25 of what it was with NeoHookean; with 1.5 spacings only to 1/1.6, with 2.6 to 1/76.
///
/// Not for ordinary compressible solids: two more sweeps, and changes of volume smaller than the support are not
/// resisted. In a column twisted by a revolution (nu 0.499) the volumes of single particles went from 0.90 to 1.08, and
/// HourglassControl, without which it is not to be used, wanted alpha = 0.3 rather than 0.1.
///
/// Not for the pressure at a face to a per cent: where the volume changes by the same everywhere, a square lattice with
/// a support of 2 spacings gives 0.94 of the mean stress at a face, 1.06 in the row behind it and 0.88 at a corner.
///
/// An element turned inside out (J <= 0) is beyond it; J is then taken as 0.001.
///
/// `Average` is the kernel of the averages. Poly6 is broad and smooths best; its support is that of the solid, 2
/// spacings or more (with 1.5 the average is hardly one).
///
/// Source: the split of volume and shape: Simo and Hughes (1998); an averaged volume in the pressure only: de Souza
/// Neto et al. (1996), F-bar; both averages, from the energy: the average nodal pressure of Bonet and Burton (1998) for
/// finite elements. Here with kernel averages over particles.
template <class Average = Poly6>
struct VolumetricDeviatoric {
    static constexpr bool of_solids = true;
    struct Weigh {
        using neighbourhood = Reference;
        static constexpr bool once = true;
        using reads = Fields<mass>;
        using adds = Fields<average_weight>;

        IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
            return b[mass] * (1 / b.material.density) * ab.value(Average{});
        }
    };
    struct Volume {
        using reads = Fields<deformation_gradient>;
        using sets = Fields<volume_ratio>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            using T = typename std::remove_cvref_t<decltype(a)>::Scalar;
            return max(determinant(a[deformation_gradient]), T(1e-3));
        }
    };
    struct Sum {
        using neighbourhood = Reference;
        using reads = Fields<mass, volume_ratio>;
        using adds = Fields<volume_ratio_sum>;

        IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
            return b[mass] * (1 / b.material.density) * ab.value(Average{}) * b[volume_ratio];
        }
    };
    struct Pressure {
        using reads = Fields<volume_ratio_sum, average_weight>;
        using sets = Fields<shared_mean_stress>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            const auto mean = a[volume_ratio_sum] / a[average_weight];
            return 0.5 * a.material.bulk_modulus() * (mean - 1 / mean) / a[average_weight];
        }
    };
    struct Share {
        using neighbourhood = Reference;
        using reads = Fields<mass, shared_mean_stress>;
        using adds = Fields<averaged_mean_stress>;

        IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
            return b[mass] * (1 / b.material.density) * ab.value(Average{}) * b[shared_mean_stress];
        }
    };
    struct Stress {
        using reads = Fields<deformation_gradient, volume_ratio, averaged_mean_stress>;
        using sets = Fields<first_piola_stress>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            using A = std::remove_cvref_t<decltype(a)>;
            using T = typename A::Scalar;
            const auto F = a[deformation_gradient];
            const T J = a[volume_ratio];
            const T I1 = trace(transpose(F) * F) + T(3 - A::dimension); // the third stretch of plane strain is one
            const T shear = T(a.material.shear_modulus) * pow(J, -2.0 / 3);
            const auto cofactor = transpose(adjugate(F)); // J F^-T
            return shear * F + (a[averaged_mean_stress] - shear * I1 / (3 * J)) * cofactor;
        }
    };
    using parts = Parts<Weigh, Volume, Sum, Pressure, Share, Stress>;

    /// (c/c_0)^2 at the deformation F or a little more, where the volume is not averaged: the square of the fastest
    /// wave's speed over that of the stress-free solid. The acoustic tensor of a wave with the stress-free normal N is G
    /// J^(-2/3) [1 - 2/3 (n (x) m + m (x) n) + 5/9 I_1 m (x) m] + K/2 (J^2 + 1) m (x) m, n = F N, m = F^-T N, n.m = 1, Pa;
    /// |n|^2 and |m|^2 are at most the greatest eigenvalues of F^T F and its inverse, of which there are bounds
    /// (detail::greatest_row_sum).
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
    /// That of NeoHookean, s.
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        return detail::elastic_wave_limit(material, in);
    }
};

} // namespace imbibe
