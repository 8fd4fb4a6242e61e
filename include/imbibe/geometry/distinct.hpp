// A check of a set of points: all coordinates finite, no two points in the same place.
#pragma once

#include <imbibe/geometry/point.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace imbibe {

namespace detail {

/// require_distinct, whose messages begin with `who`.
template <int dim>
void require_distinct(const std::string& who, const std::vector<Point<dim>>& points, double spacing) {
    const double nearest = 1e-3 * spacing;
    // Cells 16 times the least distance wide: a cell holds a bounded number of distinct points for any input, and few
    // points lie so near to its border that the next cell must be checked too.
    const double cell = 16 * nearest;

    std::size_t buckets = 16;
    while (buckets < 2 * points.size())
        buckets *= 2;
    constexpr std::size_t nobody = ~std::size_t{0};
    std::vector<std::size_t> newest(buckets, nobody);
    std::vector<std::size_t> older(points.size(), nobody);

    using CellIndex = Eigen::Matrix<std::int64_t, dim, 1>;
    const auto cell_of = [&](const Point<dim>& point) {
        CellIndex result;
        for (int axis = 0; axis < dim; ++axis)
            result[axis] = static_cast<std::int64_t>(std::floor(point[axis] / cell));
        return result;
    };
    const auto bucket_of = [&](const CellIndex& place) {
        std::uint64_t hash = 0;
        for (int axis = 0; axis < dim; ++axis) {
            hash = (hash ^ static_cast<std::uint64_t>(place[axis])) * 0x9e3779b97f4a7c15ULL;
            hash ^= hash >> 32; // lattices differ in few bits; fold the well mixed upper half onto the lower
        }
        return hash & (buckets - 1);
    };

    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point<dim>& point = points[i];
        // Not require(): it would build the texts for every particle.
        if (!point.allFinite())
            throw Error(text(who, ": point ", i, " of ", points.size(), " is at ", point_text<dim>(point),
                             "; every coordinate must be finite. Look at what made the points."));
        if (!(point.array().abs() < 1e15 * cell).all())
            throw Error(text(who, ": point ", i, " is at ", point_text<dim>(point),
                             ", too far from the origin for a spacing of ", spacing,
                             " m (at most 1e13 spacings). Give points and spacing in the same unit, metres."));
        const CellIndex from = cell_of(point - Point<dim>::Constant(nearest));
        const CellIndex to = cell_of(point + Point<dim>::Constant(nearest));
        CellIndex place = from;
        for (;;) {
            for (std::size_t j = newest[bucket_of(place)]; j != nobody; j = older[j])
                if ((points[j] - point).norm() < nearest)
                    throw Error(text(who, ": points ", j, " and ", i, " of ", points.size(),
                                     " coincide: ", point_text<dim>(points[j]), " and ", point_text<dim>(point),
                                     " are ", (points[j] - point).norm(), " m apart; they must be at least ", nearest,
                                     " m, 1e-3 of the spacing of ", spacing,
                                     " m, apart. Do two bodies overlap, was one added twice, or are these points not "
                                     "as far apart as the spacing?"));
            int axis = 0;
            while (axis < dim && ++place[axis] > to[axis]) {
                place[axis] = from[axis];
                ++axis;
            }
            if (axis == dim)
                break;
        }
        const std::size_t bucket = bucket_of(cell_of(point));
        older[i] = newest[bucket];
        newest[bucket] = i;
    }
}

} // namespace detail

/// Throws Error if a coordinate is NaN or infinite, or if two points are nearer to each other than 1e-3 spacing (m);
/// the message names their indices and positions. Takes time proportional to the number of points.
template <int dim>
void require_distinct(const std::vector<Point<dim>>& points, double spacing) {
    detail::require_positive("require_distinct", "spacing", spacing, "Give the distance between particles in metres.");
    detail::require_distinct<dim>("require_distinct", points, spacing);
}

} // namespace imbibe
