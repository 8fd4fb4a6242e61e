// The cubic spline, the kernel of most of the older literature.
#pragma once

#include <numbers>

#include <imbibe/kernels/kernel.hpp>

namespace imbibe {

/// w(q) = (1 - q)^3 - 4 (1/2 - q)^3, each power only where its base is positive. Support radius H = 2 h of the source.
///
/// Good for: comparison with published results; 30 to 50 neighbours in 3D, 12 to 20 in 2D. Not for: more neighbours
/// than that. The slope has its extremum at q = 1/3 and vanishes towards the centre, and the Fourier transform takes
/// both signs: with many neighbours particles form pairs (pairing instability, Dehnen and Aly 2012), which wastes them.
/// Then take a Wendland kernel.
///
/// Source: Monaghan and Lattanzio (1985), there 1 - 3/2 x^2 + 3/4 x^3 for x = r/h < 1 and (2 - x)^3/4 up to 2, which
/// is twice this w, with the factors 2/3, 10/(7 pi), 1/pi.
struct CubicSpline {
    static constexpr const char* name = "cubic spline";

    /// 8/3, 80/(7 pi), 16/pi in 1, 2, 3 dimensions.
    template <int dim>
    static constexpr double normalisation() {
        return detail::for_dimension<dim>(8.0 / 3, 80 / (7 * std::numbers::pi), 16 / std::numbers::pi);
    }
    /// w(q) = (1 - q)^3 - 4 (1/2 - q)^3
    template <class T>
    IMBIBE_INLINE static constexpr T value(T q) {
        return power<3>(positive_part(T(1) - q)) - T(4) * power<3>(positive_part(T(0.5) - q));
    }
    /// w'(q) = -3 (1 - q)^2 + 12 (1/2 - q)^2
    template <class T>
    IMBIBE_INLINE static constexpr T derivative(T q, T scale = T(1)) {
        // The difference of squares as a product, which loses no digits near the centre. Its first factor, (1 - q) - 2
        // (1/2 - q), is q in the inner half and 1 - q in the outer.
        const T outer = positive_part(T(1) - q);
        const T inner = positive_part(T(0.5) - q);
        return (T(-3) * scale) * min(q, outer) * (outer + T(2) * inner);
    }
    /// w''(q) = 6 (1 - q) - 24 (1/2 - q)
    template <class T>
    IMBIBE_INLINE static constexpr T second_derivative(T q) {
        return T(6) * positive_part(T(1) - q) - T(24) * positive_part(T(0.5) - q);
    }
};

} // namespace imbibe
