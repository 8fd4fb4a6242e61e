// Everything on one side of a plane (of a line in two dimensions): to cut other shapes with.
#pragma once

#include <imbibe/geometry/shape.hpp>

namespace imbibe {

/// All points behind a plane: (p - point) . normal <= 0. `normal` points out of the region; its length does not matter.
///
/// It has no bounds of its own; only for a normal along an axis the plane is a bound. Use it in an intersection or a
/// difference: `box & HalfSpace<3>{point, normal}`.
template <int dim>
class HalfSpace {
public:
    /// Throws Error unless both are finite and the normal is not zero.
    HalfSpace(const Point<dim>& point, const Point<dim>& normal) : point_{point}, normal_{normal} {
        detail::require_finite<dim>("HalfSpace", "point", point);
        detail::require_finite<dim>("HalfSpace", "normal", normal);
        require(!normal.isZero(0), "HalfSpace: normal = ", point_text<dim>(normal),
                " must not be zero. Give any vector that points out of the region.");
        normal_.stableNormalize(); // also if the squares of its components overflow or underflow
    }

    [[nodiscard]] const Point<dim>& point() const { return point_; }   ///< a point on the plane, m
    [[nodiscard]] const Point<dim>& normal() const { return normal_; } ///< unit normal out of the region

    /// Distance to the plane, m, negative behind it.
    [[nodiscard]] double distance(const Point<dim>& point) const { return (point - point_).dot(normal_); }

    /// Whether the point is behind the plane or on it.
    [[nodiscard]] bool contains(const Point<dim>& point) const { return (point - point_).dot(normal_) <= 0; }

    /// Unbounded; for a normal along an axis the plane is a bound.
    [[nodiscard]] Box<dim> bounds() const {
        const auto everywhere = Box<dim>::everywhere();
        for (int axis = 0; axis < dim; ++axis) {
            if (normal_ == Point<dim>::Unit(axis))
                return everywhere.below(axis, point_[axis]);
            if (normal_ == -Point<dim>::Unit(axis))
                return everywhere.above(axis, point_[axis]);
        }
        return everywhere;
    }

private:
    Point<dim> point_;
    Point<dim> normal_;
};

} // namespace imbibe
