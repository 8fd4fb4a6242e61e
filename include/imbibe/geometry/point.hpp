// Points of space, and the small checks that every shape's constructor uses.
#pragma once

#include <imbibe/core/error.hpp>

#include <Eigen/Core>

#include <cmath>
#include <string>

namespace imbibe {

/// A point (or an offset) in `dim` dimensions, in metres, double precision. `Point<3>{x, y, z}`.
template <int dim>
using Point = Eigen::Matrix<double, dim, 1>;

/// A point as readers write it: "(0.1, 0.2, 0.3) m".
template <int dim>
[[nodiscard]] std::string point_text(const Point<dim>& point) {
    std::string result = "(";
    for (int axis = 0; axis < dim; ++axis)
        result += text(axis == 0 ? "" : ", ", point[axis]);
    return result + ") m";
}

namespace detail {

/// a x b. (Eigen's own is in a header that includes its decompositions.)
inline Point<3> cross(const Point<3>& a, const Point<3>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Throws Error unless every coordinate of `point` is a finite number.
template <int dim>
void require_finite(const char* who, const char* what, const Point<dim>& point) {
    require(point.allFinite(), who, ": ", what, " = ", point_text<dim>(point),
            " must have finite coordinates (m). Look for a division by zero or an unset number.");
}

/// Throws Error unless `length` is finite and greater than zero.
inline void require_positive(const char* who, const char* what, double length, const char* remedy) {
    require(std::isfinite(length) && length > 0, who, ": ", what, " = ", length, " m must be finite and > 0 m. ",
            remedy);
}

} // namespace detail
} // namespace imbibe
