// The Wendland kernels C2, C4 and C6: the first choice for weakly compressible flow.
#pragma once

#include <numbers>

#include <imbibe/kernels/kernel.hpp>

namespace imbibe {

// Advice, printed as a template argument.
struct use_CubicSpline_or_QuinticSpline_on_a_line;

namespace detail {

/// The constant of a kernel that exists in two and three dimensions only.
template <class Kernel, int dim>
constexpr double for_plane_or_space(double plane, double space) {
    if constexpr (dim == 1)
        break_rule<rules::KernelOfAnotherDimension<Kernel, std::integral_constant<int, dim>,
                                                   use_CubicSpline_or_QuinticSpline_on_a_line>>();
    return for_dimension<dim>(0, plane, space);
}

} // namespace detail

/// w(q) = (1 - q)^4 (1 + 4 q). Support radius H = 2 h of most of the SPH literature, H of Dehnen and Aly.
///
/// Good for: nearly everything; the cheapest of the family. Its Fourier transform is positive, so particles do not pair
/// for any number of neighbours (Dehnen and Aly 2012). Not for: densities by summation with few neighbours, where the
/// narrow peak overrates the particle's own contribution (Dehnen and Aly 2012); there a spline is better. Tension still
/// clusters particles, as with any bell-shaped kernel.
///
/// Source: Wendland (1995); Dehnen and Aly (2012), Table 1 (2D and 3D; the family differs in 1D).
struct WendlandC2 {
    static constexpr const char* name = "Wendland C2";

    /// 7/pi, 21/(2 pi) in 2, 3 dimensions.
    template <int dim>
    static constexpr double normalisation() {
        return detail::for_plane_or_space<WendlandC2, dim>(7 / std::numbers::pi, 21 / (2 * std::numbers::pi));
    }
    /// w(q) = (1 - q)^4 (1 + 4 q)
    template <class T>
    IMBIBE_INLINE static constexpr T value(T q, T scale = T(1)) {
        return power<4>(positive_part(T(1) - q)) * (scale + (T(4) * scale) * q);
    }
    /// w'(q) = -20 q (1 - q)^3
    template <class T>
    IMBIBE_INLINE static constexpr T derivative(T q) {
        return q * derivative_over_q(q);
    }
    /// w'(q)/q = -20 (1 - q)^3
    template <class T>
    IMBIBE_INLINE static constexpr T derivative_over_q(T q, T scale = T(1)) {
        return (T(-cubic_slope) * scale) * power<3>(positive_part(T(1) - q));
    }
    /// w''(q) = -20 (1 - q)^2 (1 - 4 q)
    template <class T>
    IMBIBE_INLINE static constexpr T second_derivative(T q) {
        return T(-cubic_slope) * power<2>(positive_part(T(1) - q)) * (T(1) - T(4) * q);
    }
    /// See HasCubicSlope.
    static constexpr double cubic_slope = 20;
};

/// w(q) = (1 - q)^6 (1 + 6 q + 35/3 q^2). Support radius H.
///
/// Good for: as WendlandC2, where smoother second derivatives matter and 60 to 200 neighbours in 3D are affordable. Not
/// for: few neighbours: for the same H it is narrower than C2, so the same accuracy needs a larger H.
///
/// Source: Wendland (1995); Dehnen and Aly (2012), Table 1 (2D and 3D; the family differs in 1D).
struct WendlandC4 {
    static constexpr const char* name = "Wendland C4";

    /// 9/pi, 495/(32 pi) in 2, 3 dimensions.
    template <int dim>
    static constexpr double normalisation() {
        return detail::for_plane_or_space<WendlandC4, dim>(9 / std::numbers::pi, 495 / (32 * std::numbers::pi));
    }
    /// w(q) = (1 - q)^6 (1 + 6 q + 35/3 q^2)
    template <class T>
    IMBIBE_INLINE static constexpr T value(T q, T scale = T(1)) {
        return power<6>(positive_part(T(1) - q)) * (scale + q * (T(6) * scale + (T(35.0 / 3) * scale) * q));
    }
    /// w'(q) = -56/3 q (1 + 5 q) (1 - q)^5
    template <class T>
    IMBIBE_INLINE static constexpr T derivative(T q) {
        return q * derivative_over_q(q);
    }
    /// w'(q)/q = -56/3 (1 + 5 q) (1 - q)^5
    template <class T>
    IMBIBE_INLINE static constexpr T derivative_over_q(T q, T scale = T(1)) {
        return power<5>(positive_part(T(1) - q)) * (T(-56.0 / 3) * scale + (T(-5 * 56.0 / 3) * scale) * q);
    }
    /// w''(q) = -56/3 (1 - q)^4 (1 + 4 q - 35 q^2)
    template <class T>
    IMBIBE_INLINE static constexpr T second_derivative(T q) {
        return T(-56.0 / 3) * power<4>(positive_part(T(1) - q)) * (T(1) + q * (T(4) - T(35) * q));
    }
};

/// w(q) = (1 - q)^8 (1 + 8 q + 25 q^2 + 32 q^3). Support radius H.
///
/// Good for: very low noise with several hundred neighbours in 3D.
/// Not for: few neighbours, or runs where time is short: for the same H it is the narrowest of the three.
///
/// Source: Wendland (1995); Dehnen and Aly (2012), Table 1 (2D and 3D; the family differs in 1D).
struct WendlandC6 {
    static constexpr const char* name = "Wendland C6";

    /// 78/(7 pi), 1365/(64 pi) in 2, 3 dimensions.
    template <int dim>
    static constexpr double normalisation() {
        return detail::for_plane_or_space<WendlandC6, dim>(78 / (7 * std::numbers::pi), 1365 / (64 * std::numbers::pi));
    }
    /// w(q) = (1 - q)^8 (1 + 8 q + 25 q^2 + 32 q^3)
    template <class T>
    IMBIBE_INLINE static constexpr T value(T q, T scale = T(1)) {
        return power<8>(positive_part(T(1) - q)) *
               (scale + q * (T(8) * scale + q * (T(25) * scale + (T(32) * scale) * q)));
    }
    /// w'(q) = -22 q (1 + 7 q + 16 q^2) (1 - q)^7
    template <class T>
    IMBIBE_INLINE static constexpr T derivative(T q) {
        return q * derivative_over_q(q);
    }
    /// w'(q)/q = -22 (1 + 7 q + 16 q^2) (1 - q)^7
    template <class T>
    IMBIBE_INLINE static constexpr T derivative_over_q(T q, T scale = T(1)) {
        return power<7>(positive_part(T(1) - q)) *
               (T(-22) * scale + q * (T(-7 * 22) * scale + (T(-16 * 22) * scale) * q));
    }
    /// w''(q) = -22 (1 - q)^6 (1 + 6 q - 15 q^2 - 160 q^3)
    template <class T>
    IMBIBE_INLINE static constexpr T second_derivative(T q) {
        return T(-22) * power<6>(positive_part(T(1) - q)) * (T(1) + q * (T(6) - q * (T(15) + T(160) * q)));
    }
};

} // namespace imbibe
