// The axis-aligned box: a shape, and the bounds of every other shape.
#pragma once

#include <imbibe/core/rule.hpp>
#include <imbibe/geometry/point.hpp>

#include <algorithm>
#include <limits>

namespace imbibe {

/// The axis-aligned box of all points with lower <= p <= upper (a rectangle in 2D); coordinates in m.
///
/// The box is closed: its faces belong to it. fill() makes sure that two boxes with a common face do not both claim the
/// lattice points on it.
template <int dim>
class Box {
    static_assert(detail::check_dimension<dim>() || true); // reports what is wrong by itself, once

public:
    /// The box between two corners. Throws Error if a coordinate is not finite or a side is not longer than zero.
    Box(const Point<dim>& lower, const Point<dim>& upper) : lower_{lower}, upper_{upper} {
        detail::require_finite<dim>("Box", "lower corner", lower);
        detail::require_finite<dim>("Box", "upper corner", upper);
        for (int axis = 0; axis < dim; ++axis)
            require(upper[axis] > lower[axis], "Box: side ", "xyz"[axis], " is ", upper[axis] - lower[axis],
                    " m long; it must be > 0 m. The first corner is the lower one: lower = ", point_text<dim>(lower),
                    ", upper = ", point_text<dim>(upper), ".");
    }

    /// The unbounded box: the bounds of a shape that has none.
    [[nodiscard]] static Box everywhere() {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        return Box{Unchecked{}, Point<dim>::Constant(-infinity), Point<dim>::Constant(infinity)};
    }

    [[nodiscard]] const Point<dim>& lower() const { return lower_; }                        ///< lower corner, m
    [[nodiscard]] const Point<dim>& upper() const { return upper_; }                        ///< upper corner, m
    [[nodiscard]] Point<dim> size() const { return upper_ - lower_; }                       ///< lengths of the sides, m
    [[nodiscard]] Point<dim> centre() const { return lower_ + 0.5 * size(); }               ///< middle of the box, m
    [[nodiscard]] double volume() const { return size().prod(); }                           ///< m^dim
    [[nodiscard]] bool bounded() const { return lower_.allFinite() && upper_.allFinite(); } ///< no side is infinite

    /// Whether the point is in the box or on its faces.
    [[nodiscard]] bool contains(const Point<dim>& point) const {
        return (point.array() >= lower_.array()).all() && (point.array() <= upper_.array()).all();
    }

    /// Distance to the nearest face, m, negative inside.
    [[nodiscard]] double distance(const Point<dim>& point) const {
        const Point<dim> beyond = (lower_ - point).cwiseMax(point - upper_);
        return std::min(beyond.maxCoeff(), 0.0) + beyond.cwiseMax(0.0).norm();
    }

    /// The box itself.
    [[nodiscard]] Box bounds() const { return *this; }

    /// The smallest box that holds both.
    [[nodiscard]] Box joined(const Box& other) const {
        return Box{Unchecked{}, lower_.cwiseMin(other.lower_), upper_.cwiseMax(other.upper_)};
    }

    /// The part common to both. Throws Error if there is none.
    [[nodiscard]] Box common(const Box& other) const {
        const Point<dim> lower = lower_.cwiseMax(other.lower_);
        const Point<dim> upper = upper_.cwiseMin(other.upper_);
        require((upper.array() > lower.array()).all(), "Box: the boxes from ", point_text<dim>(lower_), " to ",
                point_text<dim>(upper_), " and from ", point_text<dim>(other.lower_), " to ",
                point_text<dim>(other.upper_),
                " have no volume in common, so an intersection of shapes in them is empty. Move one of them.");
        return Box{Unchecked{}, lower, upper};
    }

    /// This box with one bound moved in: the part where coordinate `axis` is at most `value` (m).
    [[nodiscard]] Box below(int axis, double value) const {
        Box result = *this;
        result.upper_[axis] = std::min(result.upper_[axis], value);
        return result;
    }

    /// This box with one bound moved in: the part where coordinate `axis` is at least `value` (m).
    [[nodiscard]] Box above(int axis, double value) const {
        Box result = *this;
        result.lower_[axis] = std::max(result.lower_[axis], value);
        return result;
    }

private:
    struct Unchecked {};
    Box(Unchecked, const Point<dim>& lower, const Point<dim>& upper) : lower_{lower}, upper_{upper} {}

    Point<dim> lower_;
    Point<dim> upper_;
};

} // namespace imbibe
