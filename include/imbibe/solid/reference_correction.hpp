// Corrected gradients for a total-Lagrangian solid: exact for linear fields, also at faces, edges and corners.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/lattice.hpp>
#include <imbibe/core/term.hpp>
#include <imbibe/kernels/moment_matrix.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/solid/first_piola.hpp>

namespace imbibe {

/// S_a = sqrt(s_a) sum_b V_b |L_a grad_a W_ab|, 1/m, with the stress share s_a: an upper bound of a gradient at
/// particle a for displacements of 1 m.
struct GradientSum : Field<Rank::scalar> {
    static constexpr std::string_view name = "gradient_sum", unit = "1/m";
};
inline constexpr GradientSum gradient_sum{};

/// The share of its stress that a particle carries, from 0 to 1: 1 if it has neighbours in all directions, so that they
/// determine its deformation.
struct StressShare : Field<Rank::scalar> {
    static constexpr std::string_view name = "stress_share", unit = "1";
};
inline constexpr StressShare stress_share{};

namespace detail {

/// M^-1 where `share` is above 0, and (M^2 + least^2)^-1 M where it is 0.
template <class T, int dim>
IMBIBE_INLINE constexpr SymmetricTensor<T, dim> inverse_in_some_directions(const SymmetricTensor<T, dim>& moments,
                                                                           const T& share, double least) {
    const auto M = full(moments);
    const T exactly = min(T(1e30) * share, T(1)); // 0 or 1
    const auto exact = inverse(M + (1 - exactly) * identity<T, dim>());
    const auto partial = inverse(M * M + T(sq(max(least, 1e-6))) * identity<T, dim>()) * M;
    return symmetric_part(exactly * exact + (1 - exactly) * partial);
}

// The moment sum_b V_b x^2 |grad W|/r in one direction, inside a lattice of `support` spacings a support radius: near 1
// with 2 spacings and more, 0.66 with 1.5.
template <class Kernel, int dim>
double lattice_moment(double support) {
    return Lattice<dim>{1, support}.sum([](const auto& ab) { return -sq(ab.offset[0]) * ab.gradient(Kernel{}); });
}

} // namespace detail

/// Coefficients of ReferenceCorrection.
struct ReferenceCorrectionParameters {
    /// A particle carries all of its stress where 1/|M_a^-1|, nearly the least moment in any direction, is at least
    /// this. It is 0.58 inside, 0.2 at the corner of a cube (0.13 with a support of 3 spacings), 0.08 and more in a
    /// block of two by two by two particles, 0 for a sheet or a thread of single particles, and for a rough sheet or
    /// thread between 0 and the square of its roughness in spacings.
    double full_above = 0.08;
    /// It carries none where that is below this, and a part between the two. Without this limit rough sheets of single
    /// particles have corrections of several hundred, and correspondingly short stable steps.
    double none_below = 0.04;

    /// Throws Error for a number out of range. @param where the phase in the message
    void check(std::string_view where) const {
        require_not_negative(none_below, where, "ReferenceCorrectionParameters::none_below", "");
        require(full_above >= none_below, where, ": ReferenceCorrectionParameters::full_above = ", full_above,
                "; it must be at least none_below, ", none_below);
    }
};

/// L_a = M_a^-1, from M_a = sum_b V_b (X_b - X_a) (x) grad_a W_ab with the stress-free positions X and volumes V =
/// m/rho_0; computed once, when the particles are added. Gradients of linear fields are then exact at every particle
/// that has neighbours in all directions.
///
/// For other particles (a sheet, a thread, a single particle) M cannot be inverted. Such a particle carries no stress,
/// and intermediate ones a part of it, the stress share s_a: the elastic energy is sum_a s_a V_a psi(F_a), which no
/// rotation changes, so angular momentum is conserved. L is then (M^2 + e^2)^-1 M with e = none_below, exact in the
/// directions in which there are neighbours. So not for such parts, which only HourglassControl holds together: make
/// them at least two particles thick.
///
/// Source: Bonet and Lok (1999); Vignjevic, Reveles and Campbell (2006).
template <class Kernel = WendlandC2>
struct ReferenceCorrection {
    using corrected_kernel = Kernel;
    using Parameters = ReferenceCorrectionParameters;

    struct Moments {
        using neighbourhood = Reference;
        static constexpr bool once = true;
        using reads = Fields<mass>;
        using adds = Fields<moment_matrix>;

        IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
            const auto weight = -(b[mass] / b.material.density * ab.gradient(Kernel{}));
            return weight * symmetric_part(outer(ab.offset, ab.offset));
        }
    };
    struct Share {
        static constexpr bool once = true;
        using reads = Fields<moment_matrix>;
        using sets = Fields<stress_share>;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            return detail::gated_inverse(a[moment_matrix], parameters.full_above, parameters.none_below).trust;
        }
    };
    struct Invert {
        static constexpr bool once = true;
        using reads = Fields<moment_matrix, stress_share>;
        using sets = Fields<gradient_correction>;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            using T = typename std::remove_cvref_t<decltype(a)>::Scalar;
            return detail::inverse_in_some_directions(a[moment_matrix], T(a[stress_share]), parameters.none_below);
        }
    };
    struct Sum {
        using neighbourhood = Reference;
        static constexpr bool once = true;
        using reads = Fields<mass, gradient_correction, stress_share>;
        using adds = Fields<gradient_sum>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const auto corrected = full(a[gradient_correction]) * ab.offset;
            return -(b[mass] / b.material.density * ab.gradient(Kernel{})) *
                   sqrt(a[stress_share] * squared_norm(corrected));
        }
    };
    using parts = Parts<Moments, Share, Invert, Sum>;

    static constexpr const char* limit_name = "corrected gradients";
    struct GreatestSum {
        using reads = Fields<gradient_sum>;
        using reduces = Max<GradientSum>;
        double operator()(const auto& a) const { return a[gradient_sum]; }
    };
    struct LeastTrace {
        using reads = Fields<gradient_correction>;
        using reduces = Min<GradientCorrection>;
        double operator()(const auto& a) const { return trace(a[gradient_correction]); }
    };
    using reductions = Parts<GreatestSum, LeastTrace>;
    /// The lesser of two limits, s, of irregular and of thin bodies, c being the speed of longitudinal waves:
    ///
    /// spacing/(c (1 + 3 (S/S_0 - 1))) where the greatest S_a is above S_0, 2.82/spacing in 3D and 2/spacing in 2D, its
    /// greatest value on lattices: irregular particles with few neighbours have large corrections and are stiffer.
    /// Fitted to shaken sheets, rows and blocks of various irregularity, with supports of 1.5 to 2.6 spacings: the
    /// longest stable step is 0.84 to 1.9 times this.
    ///
    /// The law's limit ("elastic wave") for a support t times as short (except its factors for supports below two
    /// spacings and for nu/(1 - nu) above a half, which stay), or 1/t^(1/4) of it if that is less, in bodies where the
    /// gradients of every particle are corrected by more than in a large body: t is the least trace of L, over that
    /// inside a lattice, above 1.1 in bodies two particles thick and in some of three. For plates, bars and blocks of
    /// two to four particles, supports of 1.5 to 2.6 spacings and all Poisson's ratios up to 0.499 the longest stable
    /// step is 0.98 to 1.45 times this and the law's (tests/terms/test_total_lagrangian.cpp).
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        double limit = std::numeric_limits<double>::infinity();
        if constexpr (requires { material.longitudinal_wave_speed(); }) {
            const double excess = in.greatest * in.spacing / (in.dimension == 2 ? 2.0 : 2.82) - 1;
            const double rate = material.longitudinal_wave_speed() / in.spacing * (1 + 3 * excess);
            if (excess > 0 && rate > 0)
                limit = 1 / rate;
            const double r = in.support_radius / in.spacing;
            const double moment =
                in.dimension == 2 ? detail::lattice_moment<Kernel, 2>(r) : detail::lattice_moment<Kernel, 3>(r);
            const double thinness = moment * in.least / in.dimension;
            if (thinness > 1.1)
                limit = std::min(limit, detail::elastic_wave_limit(material, in, thinness));
        }
        return limit;
    }
};

} // namespace imbibe
