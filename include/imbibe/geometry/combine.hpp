// Shapes from shapes: union a | b, difference a - b, intersection a & b.
#pragma once

#include <imbibe/geometry/shape.hpp>

namespace imbibe {

namespace detail {

template <class A, class B>
concept ShapesOfOneSpace = AnyShape<A> && AnyShape<B> && shape_dimension<A>
== shape_dimension<B>;

} // namespace detail

/// The points that are in `a` or in `b`. Write `a | b`.
template <AnyShape A, AnyShape B>
struct Union {
    A a; ///< one shape
    B b; ///< the other

    /// Whether the point is in either.
    [[nodiscard]] bool contains(const Point<shape_dimension<A>>& point) const {
        return a.contains(point) || b.contains(point);
    }
    /// The box round both.
    [[nodiscard]] Box<shape_dimension<A>> bounds() const { return a.bounds().joined(b.bounds()); }
};

/// The points of `a` that are not in `b`. Write `a - b`. The surface of `b` belongs to `b`, so it is not part of it.
template <AnyShape A, AnyShape B>
struct Difference {
    A a; ///< the shape that is cut
    B b; ///< what is cut away

    /// Whether the point is in `a` and not in `b`.
    [[nodiscard]] bool contains(const Point<shape_dimension<A>>& point) const {
        return a.contains(point) && !b.contains(point);
    }
    /// The bounds of `a` (not tight if `b` cuts off a whole end).
    [[nodiscard]] Box<shape_dimension<A>> bounds() const { return a.bounds(); }
};

/// The points that are in `a` and in `b`. Write `a & b`. bounds() throws Error if their boxes do not overlap.
template <AnyShape A, AnyShape B>
struct Intersection {
    A a; ///< one shape
    B b; ///< the other

    /// Whether the point is in both.
    [[nodiscard]] bool contains(const Point<shape_dimension<A>>& point) const {
        return a.contains(point) && b.contains(point);
    }
    /// The common part of both boxes.
    [[nodiscard]] Box<shape_dimension<A>> bounds() const { return a.bounds().common(b.bounds()); }
};

/// Union of two shapes.
template <class A, class B>
requires detail::ShapesOfOneSpace<A, B>
[[nodiscard]] Union<A, B> operator|(const A& a, const B& b) {
    return {a, b};
}

/// Difference of two shapes.
template <class A, class B>
requires detail::ShapesOfOneSpace<A, B>
[[nodiscard]] Difference<A, B> operator-(const A& a, const B& b) {
    return {a, b};
}

/// Intersection of two shapes. Throws Error at once if their boxes do not overlap.
template <class A, class B>
requires detail::ShapesOfOneSpace<A, B>
[[nodiscard]] Intersection<A, B> operator&(const A& a, const B& b) {
    (void)a.bounds().common(b.bounds());
    return {a, b};
}

} // namespace imbibe
