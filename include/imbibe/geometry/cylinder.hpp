// The straight round cylinder with flat ends, in three dimensions.
#pragma once

#include <imbibe/geometry/shape.hpp>

#include <numbers>

namespace imbibe {

/// All points within `radius` of the line that runs from `start` for `length` along `axis` (lengths in m; the length of
/// `axis` itself does not matter). Ends and lateral surface belong to it.
class Cylinder {
public:
    /// Throws Error unless all numbers are finite, radius and length > 0 m and the axis not zero.
    Cylinder(const Point<3>& start, const Point<3>& axis, double radius, double length)
        : start_{start}, axis_{axis}, radius_{radius}, length_{length} {
        detail::require_finite<3>("Cylinder", "start", start);
        detail::require_finite<3>("Cylinder", "axis", axis);
        require(!axis.isZero(0), "Cylinder: axis = ", point_text<3>(axis),
                " must not be zero. Give any vector along the cylinder.");
        detail::require_positive("Cylinder", "radius", radius, "Give the radius in metres.");
        detail::require_positive("Cylinder", "length", length, "Give the length in metres; turn the axis instead.");
        axis_.stableNormalize(); // also if the squares of its components overflow or underflow
    }

    [[nodiscard]] const Point<3>& start() const { return start_; } ///< centre of the first end, m
    [[nodiscard]] const Point<3>& axis() const { return axis_; }   ///< unit vector along the cylinder
    [[nodiscard]] double radius() const { return radius_; }        ///< m
    [[nodiscard]] double length() const { return length_; }        ///< m

    /// pi r^2 L, m^3.
    [[nodiscard]] double volume() const { return std::numbers::pi * radius_ * radius_ * length_; }

    /// Distance to the surface, m, negative inside.
    [[nodiscard]] double distance(const Point<3>& point) const {
        const double along = (point - start_).dot(axis_);
        const double end = std::max(-along, along - length_);
        const double mantle = (point - start_ - along * axis_).norm() - radius_;
        return std::min(std::max(end, mantle), 0.0) + std::hypot(std::max(end, 0.0), std::max(mantle, 0.0));
    }

    /// Whether the point is in the cylinder or on its surface.
    [[nodiscard]] bool contains(const Point<3>& point) const {
        const Point<3> offset = point - start_;
        const double along = offset.dot(axis_);
        const Point<3> across = offset - along * axis_;
        return along >= 0 && along <= length_ && across.squaredNorm() <= radius_ * radius_;
    }

    /// The tightest axis-aligned box: each end disc reaches r sqrt(1 - a_i^2) along coordinate i.
    [[nodiscard]] Box<3> bounds() const {
        Point<3> lower, upper;
        for (int i = 0; i < 3; ++i) {
            const double end = start_[i] + length_ * axis_[i];
            const double reach = radius_ * std::sqrt(std::max(1 - axis_[i] * axis_[i], 0.0));
            lower[i] = std::min(start_[i], end) - reach;
            upper[i] = std::max(start_[i], end) + reach;
        }
        return {lower, upper};
    }

private:
    Point<3> start_;
    Point<3> axis_;
    double radius_;
    double length_;
};

} // namespace imbibe
