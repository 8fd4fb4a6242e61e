// The share of a shape that is thinner than a width.
#pragma once

#include <imbibe/geometry/distance_transform.hpp>
#include <imbibe/geometry/level_set.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace imbibe {

/// The share (0 to 1) of a shape that is thinner than `width`, m: the part that no ball of this diameter covers that
/// fits into the shape. Edges and corners count, because no ball reaches into them.
///
/// Computed on the nodes of a grid of width/6, so a width is right within a cell. Throws Error as LevelSet does, and
/// unless the width is finite and > 0 m.
///
/// Source: the local thickness of Hildebrand and Ruegsegger (1997), for one width.
template <AnyShape S>
[[nodiscard]] double thin_share(const S& shape, double width) {
    constexpr int dim = shape_dimension<S>;
    detail::require_positive("thin_share", "width", width, "Give the width in metres.");
    const double cell = width / 6, radius = 0.5 * width;
    const LevelSet<dim> depth(shape, cell, shape.bounds().lower(), radius + cell);
    std::array<std::size_t, static_cast<std::size_t>(dim)> nodes;
    std::array<double, static_cast<std::size_t>(dim)> step;
    for (std::size_t k = 0; k < dim; ++k)
        nodes[k] = static_cast<std::size_t>(depth.nodes()[k]), step[k] = 1;
    constexpr double nowhere = 1e15;
    std::vector<double> to_middle(depth.values().size()); // from a node to the middle of a ball, cells squared
    for (std::size_t i = 0; i < to_middle.size(); ++i)    // a middle may lie half a cell beside a node
        to_middle[i] = -static_cast<double>(depth.values()[i]) >= radius - 0.5 * cell ? 0.0 : nowhere;
    detail::spread_distances<dim>(to_middle, nodes, step);
    double inside = 0, thin = 0;
    for (std::size_t i = 0; i < to_middle.size(); ++i)
        if (const double part = std::clamp(0.5 - static_cast<double>(depth.values()[i]) / cell, 0.0, 1.0); part > 0) {
            inside += part; // of the cell round a node
            thin += std::sqrt(to_middle[i]) * cell > radius + 0.5 * cell ? part : 0;
        }
    return inside > 0 ? thin / inside : 0.0;
}

} // namespace imbibe
