// The ball; a disc in two dimensions.
#pragma once

#include <imbibe/geometry/shape.hpp>

#include <numbers>

namespace imbibe {

/// All points at most `radius` from `centre` (m): a ball in 3D, a disc in 2D.
template <int dim>
class Sphere {
public:
    /// Throws Error unless the centre is finite and the radius is finite and > 0 m.
    Sphere(const Point<dim>& centre, double radius) : centre_{centre}, radius_{radius} {
        detail::require_finite<dim>("Sphere", "centre", centre);
        detail::require_positive("Sphere", "radius", radius, "Give the radius in metres.");
    }

    [[nodiscard]] const Point<dim>& centre() const { return centre_; } ///< m
    [[nodiscard]] double radius() const { return radius_; }            ///< m

    /// 4/3 pi r^3 (m^3), or pi r^2 (m^2) in 2D.
    [[nodiscard]] double volume() const {
        using std::numbers::pi;
        return dim == 2 ? pi * radius_ * radius_ : 4.0 / 3.0 * pi * radius_ * radius_ * radius_;
    }

    /// Distance to the surface, m, negative inside.
    [[nodiscard]] double distance(const Point<dim>& point) const { return (point - centre_).norm() - radius_; }

    /// Whether the point is in the ball or on its surface.
    [[nodiscard]] bool contains(const Point<dim>& point) const {
        return (point - centre_).squaredNorm() <= radius_ * radius_;
    }

    /// The tightest axis-aligned box.
    [[nodiscard]] Box<dim> bounds() const {
        const Point<dim> reach = Point<dim>::Constant(radius_);
        return Box<dim>{centre_ - reach, centre_ + reach};
    }

private:
    Point<dim> centre_;
    double radius_;
};

} // namespace imbibe
