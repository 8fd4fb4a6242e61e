// The quintic spline: smoother, wider and more expensive than the cubic one.
#pragma once

#include <numbers>

#include <imbibe/kernels/kernel.hpp>

namespace imbibe {

/// w(q) = (3 - x)^5 - 6 (2 - x)^5 + 15 (1 - x)^5 with x = 3 q, each power only where its base is positive.
/// Support radius H = 3 h of the source.
///
/// Good for: viscous flow at low Reynolds number and smooth fields; close to a Gaussian, four times differentiable. Not
/// for: speed, since at equal resolution it needs (3/2)^dim as many neighbours as the cubic spline; nor for an H beyond
/// 3 times the usual smoothing length: as every spline it pairs particles if there are too many neighbours (Dehnen and
/// Aly 2012), only later than the cubic one.
///
/// Source: Schoenberg (1946), M6; Morris, Fox and Zhu (1997), factor 7/(478 pi h^2) in 2D. For 3D the factor
/// 3/(359 pi h^3) is also in circulation: it does not integrate to one, 1/(120 pi h^3) does.
struct QuinticSpline {
    static constexpr const char* name = "quintic spline";

    /// 1/40, 63/(478 pi), 9/(40 pi) in 1, 2, 3 dimensions.
    template <int dim>
    static constexpr double normalisation() {
        return detail::for_dimension<dim>(1.0 / 40, 63 / (478 * std::numbers::pi), 9 / (40 * std::numbers::pi));
    }
    /// w(q) = (3 - x)^5 - 6 (2 - x)^5 + 15 (1 - x)^5
    template <class T>
    IMBIBE_INLINE static constexpr T value(T q) {
        const T outer = T(3) * positive_part(T(1) - q);
        return power<5>(outer) - T(6) * power<5>(positive_part(outer - T(1))) +
               T(15) * power<5>(positive_part(outer - T(2)));
    }
    /// w'(q) = -15 ((3 - x)^4 - 6 (2 - x)^4 + 15 (1 - x)^4)
    template <class T>
    IMBIBE_INLINE static constexpr T derivative(T q, T scale = T(1)) {
        // The three powers cancel at the centre. For x < 1 their sum is 24 x - 24 x^3 + 10 x^4, which does not; both
        // forms are 10 at x = 1, so with x clamped to 1 on the other side of each, their product is ten times the sum.
        const T inner = min(T(3) * q, T(1));
        const T outer = min(T(3) * positive_part(T(1) - q), T(2));
        return (T(-1.5) * scale) * (inner * (T(24) - inner * inner * (T(24) - T(10) * inner))) *
               (power<4>(outer) - T(6) * power<4>(positive_part(outer - T(1))));
    }
    /// w''(q) = 180 ((3 - x)^3 - 6 (2 - x)^3 + 15 (1 - x)^3)
    template <class T>
    IMBIBE_INLINE static constexpr T second_derivative(T q) {
        const T outer = T(3) * positive_part(T(1) - q);
        return T(180) * (power<3>(outer) - T(6) * power<3>(positive_part(outer - T(1))) +
                         T(15) * power<3>(positive_part(outer - T(2))));
    }
};

} // namespace imbibe
