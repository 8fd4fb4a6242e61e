// Checks new particles of a total-Lagrangian phase: as neighbours are found in the stress-free state, none may be added
// where a particle was that has left.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/geometry/point.hpp>
#include <imbibe/search/grid.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace imbibe::detail {

/// Throws Error, which begins with the name of the phase, if one of the new places, which are also stress-free
/// positions, is within the support radius (m) of the stress-free position free_of_stress(i) of one of `count`
/// particles that has moved from there to place(i) by more than a tenth of the distance: the two would be permanent
/// neighbours, with that strain between them. @param origin of the coordinates in the message, m
template <int dim>
void require_unstrained_neighbours(const std::vector<Point<dim>>& added, int count, const auto& free_of_stress,
                                   const auto& place, double support, const search::Periodic<dim>& periodic,
                                   const Point<dim>& origin, const std::string& name) {
    if (added.empty())
        return;
    using Cell = std::array<double, static_cast<std::size_t>(dim)>; // as wide as the support
    const auto cell_of = [&](const Point<dim>& x) {
        Cell cell;
        for (int d = 0; d < dim; ++d)
            cell[static_cast<std::size_t>(d)] = std::floor(x[d] / support);
        return cell;
    };
    std::vector<std::pair<Cell, std::size_t>> by_cell(added.size());
    Point<dim> low = added.front(), high = low;
    for (std::size_t k = 0; k < added.size(); ++k) {
        by_cell[k] = {cell_of(added[k]), k};
        low = low.cwiseMin(added[k]);
        high = high.cwiseMax(added[k]);
    }
    low.array() -= support;
    high.array() += support;
    std::sort(by_cell.begin(), by_cell.end());

    constexpr int around = dim == 3 ? 27 : 9; // a particle, its images and its cell, those beside them
    const auto step = [](int k, int d) { return (k / (d == 0 ? 1 : d == 1 ? 3 : 9)) % 3 - 1; };
    const auto look = [&](int i, const Point<dim>& from, const Point<dim>& moved) {
        const Cell middle = cell_of(from);
        for (int k = 0; k < around; ++k) {
            Cell cell = middle;
            for (int d = 0; d < dim; ++d)
                cell[static_cast<std::size_t>(d)] += step(k, d);
            auto at = std::lower_bound(by_cell.begin(), by_cell.end(), std::pair(cell, std::size_t{0}));
            for (; at != by_cell.end() && at->first == cell; ++at) {
                const double distance = (added[at->second] - from).norm();
                if (distance >= support || moved.norm() <= 0.1 * distance)
                    continue;
                throw Error(
                    text(name, ": point ", at->second, " at ", point_text<dim>(added[at->second] + origin), " m is ",
                         distance, " m from ", point_text<dim>(from + origin), " m, where particle ", i,
                         " of the phase is free of stress, which is ", moved.norm(),
                         " m away from there now. A total-Lagrangian phase finds neighbours once, at the places "
                         "free of stress, so the two would be one body that is torn apart; they must be at "
                         "least the support radius of ",
                         support,
                         " m apart there. Add the new body where none of the phase was put and shift "
                         "its positions, all by the same, to where it is to be; or give it a phase of "
                         "its own"));
            }
        }
    };
    for (int i = 0; i < count; ++i) {
        const Point<dim> from = free_of_stress(i), moved = place(i) - from;
        if (moved.isZero(0))
            continue;
        for (int image = 0; image < around; ++image) {
            Point<dim> there = from;
            bool exists = true;
            for (int d = 0; d < dim; ++d) {
                const double length = periodic.length[static_cast<std::size_t>(d)];
                there[d] += step(image, d) * length;
                exists &= (length > 0 || step(image, d) == 0) && there[d] > low[d] && there[d] < high[d];
            }
            if (exists)
                look(i, there, moved);
        }
    }
}

} // namespace imbibe::detail
