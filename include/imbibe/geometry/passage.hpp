// The open width of a sponge: the largest ball that passes through it.
#pragma once

#include <imbibe/geometry/distance_transform.hpp>
#include <imbibe/geometry/groups.hpp>
#include <imbibe/geometry/shape.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace imbibe {

/// The diameter (m) of the largest ball that can travel through the gaps of a solid shape, from the low to the high
/// face of its bounds along `axis`, without touching the solid; 0 if no gap leads through. The space outside the bounds
/// counts as open.
///
/// Found on a lattice of cells of about `cell` metres: the distance of every open cell to the solid, then cells are
/// joined from the widest down until the two faces are connected. Up to two cells too wide, because distances run
/// between centres of cells, and up to one and a half too narrow if the middle of a pore lies between them. Takes about
/// 20 bytes of memory for each cell of the bounds. Throws Error if axis or cell are out of range or more than 1e8 cells
/// result.
template <AnyShape S>
[[nodiscard]] double widest_passage(const S& solid, int axis, double cell) {
    constexpr int dim = shape_dimension<S>;
    detail::require_positive("widest_passage", "cell", cell, "Take about a tenth of the pore's width.");
    require(axis >= 0 && axis < dim, "widest_passage: axis = ", axis, " must be from 0 to ", dim - 1, ".");
    const Box<dim> box = solid.bounds();
    require(box.bounded(), "widest_passage: the shape has no bounds. Intersect it with a box: shape & Box.");

    std::array<std::size_t, static_cast<std::size_t>(dim)> cells;
    std::array<std::size_t, static_cast<std::size_t>(dim)> stride;
    std::array<double, static_cast<std::size_t>(dim)> step; // from centre to centre, in units of `cell`: up to 1
    double total = 1;
    for (int k = 0; k < dim; ++k)
        total *= std::max(std::ceil(box.size()[k] / cell - 1e-6), 1.0);
    require(total <= 1e8, "widest_passage: cell = ", cell, " m makes ", total,
            " cells; at most 1e8 are allowed. Take a larger cell, or a smaller piece of the sponge.");
    std::size_t count = 1;
    for (std::size_t k = 0; k < dim; ++k) {
        cells[k] = static_cast<std::size_t>(std::max(std::ceil(box.size()[static_cast<int>(k)] / cell - 1e-6), 1.0));
        step[k] = box.size()[static_cast<int>(k)] / static_cast<double>(cells[k]) / cell;
        stride[k] = count;
        count *= cells[k];
    }
    const auto index_along = [&](std::size_t id, std::size_t k) { return id / stride[k] % cells[k]; };

    constexpr double no_solid = 1e15; // squared cells; stands for "no solid on this line"
    // From a cell's centre to that of the nearest solid one, squared, in units of `cell`.
    std::vector<double> distance(count);
    for (std::size_t id = 0; id < count; ++id) {
        Point<dim> centre;
        for (std::size_t k = 0; k < dim; ++k) {
            const auto n = static_cast<int>(k);
            centre[n] = box.lower()[n] +
                        (static_cast<double>(index_along(id, k)) + 0.5) * box.size()[n] / static_cast<double>(cells[k]);
        }
        distance[id] = solid.contains(centre) ? 0.0 : no_solid;
    }
    detail::spread_distances<dim>(distance, cells, step);

    // Join open cells in the order of their distance, widest first, until one group touches both faces.
    std::vector<std::uint32_t> order;
    for (std::size_t id = 0; id < count; ++id)
        if (distance[id] > 0)
            order.push_back(static_cast<std::uint32_t>(id));
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return distance[a] > distance[b]; });
    const std::size_t inlet = count, outlet = count + 1;
    detail::Groups groups(count + 2);
    std::vector<bool> open(count, false);
    const auto along = static_cast<std::size_t>(axis);
    for (const std::uint32_t id : order) {
        open[id] = true;
        for (std::size_t k = 0; k < dim; ++k) {
            const std::size_t i = index_along(id, k);
            if (i > 0 && open[id - stride[k]])
                groups.join(id - stride[k], id);
            if (i + 1 < cells[k] && open[id + stride[k]])
                groups.join(id + stride[k], id);
        }
        if (index_along(id, along) == 0)
            groups.join(inlet, id);
        if (index_along(id, along) + 1 == cells[along])
            groups.join(outlet, id);
        if (groups.of(inlet) == groups.of(outlet)) {
            const double width = 2 * std::sqrt(distance[id]) * cell;
            double widest = box.size().maxCoeff();
            for (int k = 0; k < dim; ++k)
                if (k != axis)
                    widest = std::min(widest, box.size()[k]);
            return std::min(width, widest);
        }
    }
    return 0;
}

} // namespace imbibe
