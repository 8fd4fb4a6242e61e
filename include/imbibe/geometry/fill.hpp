// Fills shapes with particles on a square or cubic lattice, at the centres of its cells.
#pragma once

#include <imbibe/geometry/shape.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace imbibe {

namespace detail {

/// A shape whose bounds have more lattice points than this is taken for a mistake in the units.
inline constexpr double most_lattice_points = 4e9;

/// A lattice point nearer to a face than this, in spacings, counts as lying on it.
inline constexpr double on_the_face = 1e-6;

/// The lattice points anchor + (i + shift) spacing near the bounds for which `inside(point)` holds; x runs fastest.
template <int dim, class Inside>
std::vector<Point<dim>> lattice_points(const char* who, const Box<dim>& bounds, double spacing,
                                       const Point<dim>& anchor, double shift, const Inside& inside) {
    require(bounds.bounded(), who, ": the shape has no bounds (lower ", point_text<dim>(bounds.lower()), ", upper ",
            point_text<dim>(bounds.upper()), "). Intersect it with a box: shape & Box.");
    require_positive(who, "spacing", spacing, "Give the distance between particles in metres.");
    require_finite<dim>(who, "anchor", anchor);
    std::array<double, static_cast<std::size_t>(dim)> first;
    std::array<double, static_cast<std::size_t>(dim)> last;
    double count = 1;
    double farthest = 0;
    for (int axis = 0; axis < dim; ++axis) {
        const auto slot = static_cast<std::size_t>(axis);
        first[slot] = std::floor((bounds.lower()[axis] - anchor[axis]) / spacing - shift) - 1;
        last[slot] = std::ceil((bounds.upper()[axis] - anchor[axis]) / spacing - shift) + 1;
        count *= std::max(bounds.size()[axis] / spacing, 1.0);
        farthest = std::max(
            {farthest, std::abs(bounds.lower()[axis]), std::abs(bounds.upper()[axis]), std::abs(anchor[axis])});
    }
    require(count <= most_lattice_points, who, ": spacing = ", spacing, " m makes about ", count,
            " lattice points in a box of sides ", point_text<dim>(bounds.size()), "; at most ", most_lattice_points,
            " are allowed. Give spacing and shape in the same unit, metres.");
    require(spacing >= 1e-9 * farthest, who, ": spacing = ", spacing, " m is too fine ", farthest,
            " m away from the origin for double precision; it must be >= ", 1e-9 * farthest,
            " m. Move the shape nearer to the origin.");

    std::vector<Point<dim>> points;
    std::array<double, static_cast<std::size_t>(dim)> index = first;
    for (;;) {
        Point<dim> point;
        for (int axis = 0; axis < dim; ++axis) // from the index, not by adding up, so that round-off cannot grow
            point[axis] = anchor[axis] + (index[static_cast<std::size_t>(axis)] + shift) * spacing;
        if (inside(point))
            points.push_back(point);
        std::size_t axis = 0;
        while (axis < dim && (index[axis] += 1) > last[axis]) {
            index[axis] = first[axis];
            ++axis;
        }
        if (axis == dim)
            break;
    }
    require(!points.empty(), who, ": no lattice point of spacing ", spacing,
            " m lies in the shape, whose box has sides ", point_text<dim>(bounds.size()),
            ". Take a smaller spacing, or check that both are in metres and that the shape is not cut away.");
    return points;
}

} // namespace detail

/// Particle positions (m) at the centres of the cells of a lattice, anchor + (i + 1/2) spacing, all that lie in the
/// shape. Each stands for a volume spacing^dim. x runs fastest, the last coordinate slowest.
///
/// The outermost particles lie half a spacing inside a face. On the face they would stand for half a cell only, and as
/// `Solver::add` gives each the mass density spacing^dim, a body of n spacings a side would have (n + 1)/n of its mass
/// in each direction. To place the outermost particles in a plane, fill a body that reaches half a spacing beyond it.
///
/// Two shapes that share a face and a lattice (same spacing, anchors a whole number of spacings apart) never both get a
/// point, and never both miss it: a point on a face belongs to the shape on the side of larger coordinates, also if
/// round-off puts it a little off the face. So a box is filled as [lower, upper), and `a - b` with `a & b` is `a`.
///
/// Throws Error if the spacing is not finite and > 0 m, the shape is unbounded, more than 4e9 or no points result, or
/// the spacing is below 1e-9 of the distance from the origin.
template <AnyShape S>
[[nodiscard]] std::vector<Point<shape_dimension<S>>> fill(const S& shape, double spacing,
                                                          const Point<shape_dimension<S>>& anchor) {
    constexpr int dim = shape_dimension<S>;
    // Ties are decided at a point shifted along every axis by more than round-off. The shifts are unequal so that they
    // do not run along a slanted face.
    Point<dim> nudge;
    for (int axis = 0; axis < dim; ++axis)
        nudge[axis] = detail::on_the_face * spacing * std::pow(0.618, axis);
    return detail::lattice_points<dim>("fill", shape.bounds(), spacing, anchor, 0.5,
                                       [&](const Point<dim>& point) { return shape.contains(point + nudge); });
}

/// The same with the lattice starting in the lower corner of the shape's bounds: a box whose sides are whole numbers
/// of spacings gets a first layer half a spacing inside every face.
template <AnyShape S>
[[nodiscard]] std::vector<Point<shape_dimension<S>>> fill(const S& shape, double spacing) {
    return fill(shape, spacing, shape.bounds().lower());
}

} // namespace imbibe
