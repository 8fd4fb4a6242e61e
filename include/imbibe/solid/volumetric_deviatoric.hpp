// A nearly incompressible rubber, W = G/2 (J^(-2/3) tr C - 3) + K/4 (mean J^2 - 1 - 2 ln mean J): the pressure follows
// from the volume change averaged over the neighbours, the rest of the stress from the particle's own deformation.
#pragma once

#include <imbibe/kernels/poly6.hpp>
#include <imbibe/solid/deformation_gradient.hpp>
#include <imbibe/solid/neo_hookean.hpp>

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

/// U'(mean J)/sum_b V_b W_ab, Pa: the mean stress of the averaged volume, ready to be averaged back.
struct SharedMeanStress : Field<Rank::scalar> {
    static constexpr std::string_view name = "shared_mean_stress", unit = "Pa";
};
inline constexpr SharedMeanStress shared_mean_stress{};

/// sum_b V_b W_ab U'_b/(sum_c V_c W_bc), Pa: the mean stress of the particle. Tension is positive.
struct AveragedMeanStress : Field<Rank::scalar> {
    static constexpr std::string_view name = "averaged_mean_stress", unit = "Pa";
};
inline constexpr AveragedMeanStress averaged_mean_stress{};

/// W = G/2 (J^(-2/3) tr C - 3) + K/4 (mean J^2 - 1 - 2 ln mean J), the energy stored in J/m^3 of the stress-free solid,
/// with C = F^T F (in 2D: plane strain, the third stretch is one and counts in tr C), J = det F and K = rho_0 c^2: the
/// law of IsochoricNeoHookean, with an averaged volume. The stress is
///
///     P = G J^(-2/3) (F - tr C/3 F^-T) + p J F^-T, in Pa.
///
/// The mean of J is the kernel average over the stress-free neighbours, mean J_a = sum_b V_b W_ab J_b / sum_b V_b W_ab.
/// The mean stress that belongs to it is averaged back with the same weights turned round, p_a = sum_b V_b W_ab U'(mean
/// J_b) / sum_c V_c W_bc with U'(J) = K/2 (J - 1/J): then the force of TotalLagrangianForce is minus the derivative of
/// the energy, and momentum, angular momentum and energy are kept as with any other law.
///
/// A law in place of the neo-Hookean ones, for Poisson's ratios near 1/2. There the local volume constrains the
/// particles more than their neighbours allow, and the mean stress alternates from particle to particle (checkerboard).
/// Averaged, it is smooth: where J alternates on a square lattice with a support of 2 spacings, 0.06 of that is left in
/// mean J, and 0.06 of that again in the mean stress. In a swinging beam (nu 0.499) the alternating part of the mean
/// stress is 1/25 of that with CompressibleNeoHookean; with 1.5 spacings only 1/1.6, with 2.6 1/76.
///
/// Not for ordinary compressible solids: it costs two more sweeps, and volume changes on scales below the support are
/// not resisted. In a column twisted by a revolution (nu 0.499) the volumes of single particles range from 0.90 to
/// 1.08. Not without HourglassControl, which needs alpha = 0.3 rather than 0.1 there.
///
/// Not for the pressure at a face to a per cent: with a uniform volume change, a square lattice with a support of 2
/// spacings gives 0.94 of the mean stress at a face, 1.06 in the row behind it and 0.88 at a corner.
///
/// An element turned inside out (J <= 0) is beyond it; J is then taken as 0.001.
///
/// `Average` is the kernel of the averages. Poly6 is broad and smooths best; its support is that of the solid, 2
/// spacings or more (1.5 hardly averages).
///
/// Source: the split of volume and shape: Simo and Hughes (1998); an averaged volume in the pressure only: de Souza
/// Neto et al. (1996), F-bar; both averages, from the energy: the average nodal pressure of Bonet and Burton (1998) for
/// finite elements. Here with kernel averages over particles.
template <class Average = Poly6>
struct VolumetricDeviatoric {
    static constexpr bool of_solids = true;
    /// J = det F of a particle, at least 1e-3.
    static IMBIBE_INLINE constexpr auto volume_ratio_of(const auto& a) {
        using T = typename std::remove_cvref_t<decltype(a)>::Scalar;
        return max(determinant(a[deformation_gradient]), T(1e-3));
    }
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
        using reads = Fields<deformation_gradient, stress_share>;
        using sets = Fields<volume_ratio>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            const auto s = a[stress_share];
            return s * volume_ratio_of(a) + (1 - s);
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
        using reads = Fields<deformation_gradient, averaged_mean_stress>;
        using sets = Fields<first_piola_stress>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            using T = typename std::remove_cvref_t<decltype(a)>::Scalar;
            return detail::isochoric_stress(a[deformation_gradient], volume_ratio_of(a), T(a.material.shear_modulus),
                                            T(a[averaged_mean_stress]));
        }
    };
    using parts = Parts<Weigh, Volume, Sum, Pressure, Share, Stress>;
    using reductions = Parts<ElasticEnergy<IsochoricNeoHookean>>; // with volumes that are not averaged

    /// That of IsochoricNeoHookean, whose volume is not averaged: a little more.
    template <class T, int n>
    static constexpr T wave_stiffening(const auto& material, const Tensor<T, n>& F) {
        return IsochoricNeoHookean::wave_stiffening(material, F);
    }

    static constexpr const char* limit_name = "elastic wave";
    /// That of CompressibleNeoHookean, s.
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        return detail::elastic_wave_limit(material, in);
    }
};

} // namespace imbibe
