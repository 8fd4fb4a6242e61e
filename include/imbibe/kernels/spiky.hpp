// The spiky kernel: its slope does not vanish at the centre.
#pragma once

#include <numbers>

#include <imbibe/kernels/kernel.hpp>

namespace imbibe {

/// w(q) = (1 - q)^3. Support radius H = h of the sources.
///
/// Good for: pressure forces. The closer two particles, the harder they push each other apart, so they do not pair.
/// Not for: densities and interpolation, since the peak at the centre makes them noisy and the direction of the
/// gradient jumps there; nor where a ratio of kernel values is raised to a power (artificial stress), which this
/// peak turns into a huge number at small distances.
///
/// Source: Desbrun and Gascuel (1996); Mueller, Charypar and Gross (2003), Eq. 21; the paper, Eq. (13). In 1D and 2D
/// the same shape, normalised by integration.
struct Spiky {
    static constexpr const char* name = "spiky";

    /// 2, 10/pi, 15/pi in 1, 2, 3 dimensions.
    template <int dim>
    static constexpr double normalisation() {
        return detail::for_dimension<dim>(2, 10 / std::numbers::pi, 15 / std::numbers::pi);
    }
    /// w(q) = (1 - q)^3
    template <class T>
    IMBIBE_INLINE static constexpr T value(T q) {
        return power<3>(positive_part(T(1) - q));
    }
    /// w'(q) = -3 (1 - q)^2
    template <class T>
    IMBIBE_INLINE static constexpr T derivative(T q, T scale = T(1)) {
        return (T(-3) * scale) * power<2>(positive_part(T(1) - q));
    }
    /// w''(q) = 6 (1 - q)
    template <class T>
    IMBIBE_INLINE static constexpr T second_derivative(T q) {
        return T(6) * positive_part(T(1) - q);
    }
};

} // namespace imbibe
