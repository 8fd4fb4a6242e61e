// The viscosity kernels of three and two dimensions, whose Laplacian is proportional to 1 - q, positive everywhere.
#pragma once

#include <cmath>
#include <numbers>
#include <type_traits>

#include <imbibe/kernels/kernel.hpp>

namespace imbibe {

// Advice, printed as a template argument.
struct use_ViscosityKernel2D_in_the_plane;
struct use_ViscosityKernel_in_space;

namespace detail {

/// Below this share of the support radius the value and the derivative of a viscosity kernel are held constant, because
/// they are infinite at q = 0. Small enough to change the integral of W by less than 1e-11, large enough for 1/q^2 in
/// float.
inline constexpr double viscosity_kernel_floor = 1e-6;

/// The natural logarithm of a positive number; in constant evaluation by halving and a series.
template <class Real>
constexpr Real logarithm(Real x) {
    if (!std::is_constant_evaluated())
        return std::log(x);
    int halvings = 0;
    for (; x < Real(0.75); x *= 2)
        ++halvings;
    const Real z = (x - 1) / (x + 1);
    Real sum = 0;
    Real term = 2 * z;
    for (int k = 1; k < 60; k += 2, term *= z * z)
        sum += term / Real(k);
    return sum - Real(halvings) * std::numbers::ln2_v<Real>;
}
template <class Real, int width>
constexpr Pack<Real, width> logarithm(Pack<Real, width> x) {
    return lane_by_lane(x, [](Real number) { return logarithm(number); });
}

} // namespace detail

/// The viscosity kernel of three dimensions,
/// w(q) = -q^3/2 + q^2 + 1/(2 q) - 1 = (1 - q)^3 (1 + q) / (2 q). Support radius H = h of the source.
/// Its Laplacian is 6 (1 - q): with the normalisation 45/pi (1 - q)/H^5, nowhere negative.
///
/// Good for: viscous forces in the form (v_b - v_a) Laplacian(W), where a negative Laplacian would drive the
/// particles apart in velocity. Only the Laplacian is meant to be used, and only between different particles: W
/// itself is infinite at q = 0. Here the value and the derivative stay finite: for q < 1e-6 they are those at 1e-6.
/// Not for: densities or pressure forces (infinite peak), or high accuracy: a sum over the Laplacian of a kernel is
/// inaccurate on disordered particles and near a surface, where part of the support is empty.
///
/// Source: Mueller, Charypar and Gross (2003), Eq. 22; the paper, Eq. (14).
struct ViscosityKernel {
    static constexpr const char* name = "viscosity kernel";

    /// 15/(2 pi), in 3 dimensions only.
    template <int dim>
    static constexpr double normalisation() {
        if constexpr (dim != 3) // its Laplacian is another one there
            detail::break_rule<rules::KernelOfAnotherDimension<ViscosityKernel, std::integral_constant<int, dim>,
                                                               use_ViscosityKernel2D_in_the_plane>>();
        return 15 / (2 * std::numbers::pi);
    }
    /// w(q) = (1 - q)^3 (1 + q) / (2 q)
    template <class T>
    IMBIBE_INLINE static constexpr T value(T q) {
        const T s = max(q, T(detail::viscosity_kernel_floor));
        return power<3>(positive_part(T(1) - s)) * (T(1) + s) / (T(2) * s);
    }
    /// w'(q) = -(1 - q)^2 (1 + 2 q + 3 q^2) / (2 q^2)
    template <class T>
    IMBIBE_INLINE static constexpr T derivative(T q) {
        const T s = max(q, T(detail::viscosity_kernel_floor));
        return -power<2>(positive_part(T(1) - s)) * (T(1) + s * (T(2) + T(3) * s)) / (T(2) * s * s);
    }
    /// w''(q) = (1 - q) (1 + q + q^2 + 3 q^3) / q^3
    template <class T>
    IMBIBE_INLINE static constexpr T second_derivative(T q) {
        const T s = max(q, T(detail::viscosity_kernel_floor));
        return positive_part(T(1) - s) * (T(1) + s * (T(1) + s * (T(1) + T(3) * s))) / power<3>(s);
    }
    /// w'' + 2 w'/q = 6 (1 - q), regular at q = 0.
    template <class T>
    IMBIBE_INLINE static constexpr T laplacian(T q, T scale = T(1)) {
        return (T(6) * scale) * positive_part(T(1) - q);
    }
};

/// The viscosity kernel of two dimensions, w(q) = 3/2 q^2 - 2/3 q^3 - ln q - 5/6. Support radius H.
/// Its Laplacian is 6 (1 - q): with the normalisation 40/pi (1 - q)/H^4, nowhere negative. The kernel of three
/// dimensions does not have this property in the plane, where its Laplacian would be w'' + w'/q.
///
/// Good for viscous forces in the plane, as ViscosityKernel is in space. Not for densities or pressure forces. The
/// singularity is logarithmic; for q < 1e-6 the value and the derivative are those at 1e-6. The value takes a logarithm
/// lane by lane, which is slow; the Laplacian does not.
///
/// Source: our own, from the condition of Mueller, Charypar and Gross (2003) for Eq. 22, in the plane: w'' + w'/q =
/// 6 (1 - q) with w(1) = w'(1) = 0. Once integrated, q w' = 3 q^2 - 2 q^3 - 1 = -(1 - q)^2 (1 + 2 q); once more gives
/// w; the integral of 2 pi q w(q) from 0 to 1 is 3 pi/20.
struct ViscosityKernel2D {
    static constexpr const char* name = "viscosity kernel (2D)";

    /// 20/(3 pi), in 2 dimensions only.
    template <int dim>
    static constexpr double normalisation() {
        if constexpr (dim != 2)
            detail::break_rule<rules::KernelOfAnotherDimension<ViscosityKernel2D, std::integral_constant<int, dim>,
                                                               use_ViscosityKernel_in_space>>();
        return 20 / (3 * std::numbers::pi);
    }
    /// w(q) = 3/2 q^2 - 2/3 q^3 - ln q - 5/6
    template <class T>
    IMBIBE_INLINE static constexpr T value(T q) {
        // In u = 1 - q, so that w is exactly zero at the rim; positive_part removes the logarithm's round-off.
        const T s = min(max(q, T(detail::viscosity_kernel_floor)), T(1));
        const T u = T(1) - s;
        return positive_part(-detail::logarithm(s) - u * (T(1) + u * (T(0.5) - T(2.0 / 3) * u)));
    }
    /// w'(q) = -(1 - q)^2 (1 + 2 q) / q
    template <class T>
    IMBIBE_INLINE static constexpr T derivative(T q) {
        const T s = max(q, T(detail::viscosity_kernel_floor));
        return -power<2>(positive_part(T(1) - s)) * (T(1) + T(2) * s) / s;
    }
    /// w''(q) = (1 - q) (1 + q + 4 q^2) / q^2
    template <class T>
    IMBIBE_INLINE static constexpr T second_derivative(T q) {
        const T s = max(q, T(detail::viscosity_kernel_floor));
        return positive_part(T(1) - s) * (T(1) + s * (T(1) + T(4) * s)) / power<2>(s);
    }
    /// w'' + w'/q = 6 (1 - q), regular at q = 0.
    template <class T>
    IMBIBE_INLINE static constexpr T laplacian(T q, T scale = T(1)) {
        return (T(6) * scale) * positive_part(T(1) - q);
    }
};

} // namespace imbibe
