// What a shape is: a type that says which points it contains and which box bounds it.
#pragma once

#include <imbibe/geometry/box.hpp>

#include <concepts>
#include <type_traits>
#include <utility>

namespace imbibe {

/// A region of `dim`-dimensional space. A small value type with two members: `bool contains(const Point<dim>&) const`
/// and `Box<dim> bounds() const`, a box (m) outside which it has no point. Bounds need not be tight, but fill() starts
/// its lattice in their lower corner. Any user type with the two members is a shape.
template <class S, int dim>
concept Shape = std::copy_constructible<S> && requires(const S& shape, const Point<dim>& point) {
    { shape.contains(point) } -> std::same_as<bool>;
    { shape.bounds() } -> std::same_as<Box<dim>>;
};

namespace detail {

template <class T>
struct BoxDimension {
    static constexpr int value = 0;
};
template <int dim>
struct BoxDimension<Box<dim>> {
    static constexpr int value = dim;
};
template <class S>
using BoundsOf = std::remove_cvref_t<decltype(std::declval<const S&>().bounds())>;

} // namespace detail

/// A shape whose number of dimensions follows from its bounds().
template <class S>
concept AnyShape = requires(const S& shape) {
    shape.bounds();
}
&&(detail::BoxDimension<detail::BoundsOf<S>>::value > 0) && Shape<S, detail::BoxDimension<detail::BoundsOf<S>>::value>;

/// The number of dimensions (2 or 3) of a shape.
template <AnyShape S>
inline constexpr int shape_dimension = detail::BoxDimension<detail::BoundsOf<S>>::value;

} // namespace imbibe
