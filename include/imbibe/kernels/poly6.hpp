// The poly6 kernel: a bell in the square of the distance, without a square root.
#pragma once

#include <numbers>

#include <imbibe/kernels/kernel.hpp>

namespace imbibe {

/// w(q) = (1 - q^2)^3. Support radius H = h of the source.
///
/// Good for: averages over neighbours: densities by summation, XSPH velocities, colour fields. Not for: pressure
/// forces. The slope vanishes at the centre, so two close particles no longer repel each other and stay together; they
/// form clusters under pressure.
///
/// Source: Mueller, Charypar and Gross (2003), Eq. 20; the paper, Eq. (20). In 1D and 2D the same shape, normalised
/// by integration.
struct Poly6 {
    static constexpr const char* name = "poly6";

    /// 35/32, 4/pi, 315/(64 pi) in 1, 2, 3 dimensions.
    template <int dim>
    static constexpr double normalisation() {
        return detail::for_dimension<dim>(35.0 / 32, 4 / std::numbers::pi, 315 / (64 * std::numbers::pi));
    }
    /// w(q) = (1 - q^2)^3
    template <class T>
    IMBIBE_INLINE static constexpr T value(T q) {
        return power<3>(positive_part(T(1) - q) * (T(1) + q)); // as a product: no digits lost near the rim
    }
    /// w'(q) = -6 q (1 - q^2)^2
    template <class T>
    IMBIBE_INLINE static constexpr T derivative(T q) {
        return q * derivative_over_q(q);
    }
    /// w'(q)/q = -6 (1 - q^2)^2
    template <class T>
    IMBIBE_INLINE static constexpr T derivative_over_q(T q, T scale = T(1)) {
        return (T(-6) * scale) * power<2>(positive_part(T(1) - q) * (T(1) + q));
    }
    /// w''(q) = -6 (1 - q^2) (1 - 5 q^2)
    template <class T>
    IMBIBE_INLINE static constexpr T second_derivative(T q) {
        return T(-6) * (positive_part(T(1) - q) * (T(1) + q)) * (T(1) - T(5) * q * q);
    }
};

} // namespace imbibe
