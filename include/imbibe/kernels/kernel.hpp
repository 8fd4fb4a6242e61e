// What a smoothing kernel is to this library, and its value and slope in physical units.
//
// A kernel is written on the unit support: q = r/H is the distance in units of the support radius H, beyond which the
// kernel is zero. The literature's "smoothing length" h is H for some kernels, H/2 or H/3 for others. The library uses
// only H, and each kernel's comment gives the relation to the h of its source.
#pragma once

#include <concepts>
#include <type_traits>

#include <imbibe/core/pack_functions.hpp>
#include <imbibe/core/rule.hpp>

namespace imbibe {

/// A smoothing kernel: a struct without state that offers, all constexpr,
///
///     static constexpr const char* name;
///     template <int dim> static constexpr double normalisation();
///     template <class T> static constexpr T value(T q);       // w(q)
///     template <class T> static constexpr T derivative(T q);  // dw/dq
///
/// so that in `dim` dimensions
///
///     W(r)   = normalisation<dim>() / H^dim * w(r/H)          [1/m^dim],     integral of W over space = 1,
///     dW/dr  = normalisation<dim>() / H^(dim+1) * w'(r/H)     [1/m^(dim+1)].
///
/// T is float, double or a Pack of them; q >= 0 and finite. At q >= 1 both functions are exactly zero; for any q the
/// value is not negative and the derivative not positive. They reach zero through truncated powers (positive_part),
/// never through a branch, so a sweep needs no test of the distance. `normalisation` gives a readable compile error in
/// a dimension in which the kernel has another shape.
///
/// Four members are optional: see HasDerivativeOverQ, HasCubicSlope, HasSecondDerivative and HasLaplacian.
///
/// A function with constants of its own may take a second argument, `T scale = T(1)`, that multiplies it: a sweep
/// passes the constant of the support there, and its products with those constants cost nothing in the pair loop.
template <class K>
concept Kernel = requires(double q, float p) {
    { K::name } -> std::convertible_to<const char*>;
    { K::template normalisation<2>() } -> std::same_as<double>;
    { K::value(q) } -> std::same_as<double>;
    { K::value(p) } -> std::same_as<float>;
    { K::derivative(q) } -> std::same_as<double>;
    { K::derivative(p) } -> std::same_as<float>;
};

/// A kernel whose derivative is q times a regular function, offered as `derivative_over_q(q)`: grad W = normalisation /
/// H^(dim+2) * derivative_over_q(r/H) * (r_a - r_b) then needs no division by the distance and is right at r = 0.
template <class K>
concept HasDerivativeOverQ = Kernel<K> && requires(double q) {
    { K::derivative_over_q(q) } -> std::same_as<double>;
};

/// Such a kernel with w'(q)/q = -cubic_slope (1 - q)^3, cubic_slope > 0, up to q = 1: a pair loop multiplies 1 - q by
/// the cube root of all constants, which needs no extra instruction, whereas their product needs a multiplication.
template <class K>
concept HasCubicSlope = HasDerivativeOverQ<K> && requires {
    { K::cubic_slope } -> std::convertible_to<double>;
};

/// A kernel that offers its second derivative w''(q): d2W/dr2 = normalisation / H^(dim+2) * second_derivative(r/H).
/// All kernels of the library do.
template <class K>
concept HasSecondDerivative = Kernel<K> && requires(double q) {
    { K::second_derivative(q) } -> std::same_as<double>;
};

/// A kernel made for its Laplacian, offered as `laplacian(q)`:
/// Laplacian of W = normalisation / H^(dim+2) * laplacian(r/H).
template <class K>
concept HasLaplacian = Kernel<K> && requires(double q) {
    { K::laplacian(q) } -> std::same_as<double>;
};

namespace rules {
/// Rule: kernels have one, two or three dimensions.
template <class Dimension>
struct NoSuchDimension {
    static_assert(sizeof(Dimension) == 0, "imbibe: kernels exist in 1, 2 and 3 dimensions");
};
/// Rule: a kernel is used in a dimension that it is made for.
template <class Kernel, class Dimension, class Advice>
struct KernelOfAnotherDimension {
    static_assert(sizeof(Kernel) == 0, "imbibe: this kernel is not made for this dimension");
};
} // namespace rules

namespace detail {

/// The kernel's constant for the dimension.
template <int dim>
constexpr double for_dimension(double line, double plane, double space) {
    if constexpr (dim < 1 || dim > 3)
        break_rule<rules::NoSuchDimension<std::integral_constant<int, dim>>>();
    return dim == 1 ? line : dim == 2 ? plane : space;
}

} // namespace detail

/// W(r) in 1/m^dim at the distance r >= 0 (m), for the support radius H > 0 (m).
template <Kernel K, int dim, class T>
IMBIBE_INLINE constexpr T kernel_value(T r, std::type_identity_t<T> H) {
    return T(K::template normalisation<dim>()) / power<dim>(H) * K::value(T(r / H));
}

/// dW/dr in 1/m^(dim+1) at the distance r >= 0 (m), for the support radius H > 0 (m).
template <Kernel K, int dim, class T>
IMBIBE_INLINE constexpr T kernel_derivative(T r, std::type_identity_t<T> H) {
    return T(K::template normalisation<dim>()) / power<dim + 1>(H) * K::derivative(T(r / H));
}

/// The Laplacian of W in 1/m^(dim+2) at the distance r >= 0 (m), for the support radius H > 0 (m).
template <HasLaplacian K, int dim, class T>
IMBIBE_INLINE constexpr T kernel_laplacian(T r, std::type_identity_t<T> H) {
    return T(K::template normalisation<dim>()) / power<dim + 2>(H) * K::laplacian(T(r / H));
}

} // namespace imbibe
