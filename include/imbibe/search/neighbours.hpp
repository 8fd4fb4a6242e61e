// Builds the runs of neighbours of one set of points in another.
#pragma once

#include <imbibe/core/pack.hpp>
#include <imbibe/search/grid.hpp>
#include <imbibe/search/runs.hpp>

#include <bit>

namespace imbibe::search {

/// The number of periodic images that can be seen: -1, 0, +1 period in each direction. Image 0 is the domain itself.
template <int dim>
inline constexpr int image_count = dim == 2 ? 9 : 27;

/// The displacement of image `shift`, in periods along d: 0, 1 or -1.
constexpr int image_step(int shift, int d) {
    for (int k = 0; k < d; ++k)
        shift /= 3;
    return shift % 3 == 2 ? -1 : shift % 3;
}

namespace detail {

// Appends the runs of one particle's neighbours among the particles [begin, end) of the sorted order.
template <int width, int dim, class Real>
IMBIBE_INLINE void append_runs(std::vector<Run>& runs, const Points<dim, Real>& sources, const Real (&at)[dim],
                               Real support2, std::uint32_t begin, std::uint32_t end, int shift) {
    using T = Pack<Real, width>;
    for (std::uint32_t j = begin; j < end;) {
        T distance2(0);
        for (std::size_t d = 0; d < dim; ++d)
            distance2 += sq(T(at[d]) - T::load(sources.x[d] + j));
        std::uint32_t hits = less_bits(distance2, T(support2));
        const std::uint32_t left = end - j;
        if (left < static_cast<std::uint32_t>(width))
            hits &= (1u << left) - 1;
        if (hits == 0) {
            j += static_cast<std::uint32_t>(width);
            continue;
        }
        const std::uint32_t first = j + static_cast<std::uint32_t>(std::countr_zero(hits));
        const std::uint32_t count = std::min(static_cast<std::uint32_t>(width), end - first);
        runs.push_back({first, static_cast<std::uint16_t>(count), static_cast<std::uint16_t>(shift)});
        j = first + static_cast<std::uint32_t>(width);
    }
}

} // namespace detail

/// For every target point, the runs of source points nearer than `support`. The sources are in the order of `table`.
/// Runs may hold points beyond the support as well: compact kernels give them zero. Targets outside a periodic box are
/// moved into it first, so the images of their runs are those seen from there.
template <int width, int dim, class Real>
void find_runs(RunList& list, const Points<dim, Real>& targets, const Points<dim, Real>& sources,
               const Grid<dim>& grid, const CellTable& table, double support, int threads) {
    list.resize(targets.n);
    const Real support2 = static_cast<Real>(support * support);
    const std::size_t row_length = static_cast<std::size_t>(grid.n(0));
    const auto place = [&](Real x, int d) {
        return grid.wraps(d) ? into_period(x, static_cast<Real>(grid.lower(d)), static_cast<Real>(grid.length(d))) : x;
    };
    parallel_for(list.block_count(), threads, [&](int block) {
        std::vector<Run>& runs = list.block(block);
        runs.clear();
        const int end = std::min(targets.n, (block + 1) * RunList::block_size);
        for (int i = block * RunList::block_size; i < end; ++i) {
            double at[dim];
            for (int d = 0; d < dim; ++d)
                at[d] = static_cast<double>(place(targets.x[static_cast<std::size_t>(d)][i], d));
            // One row of cells: how far it is across, which image it belongs to, and its stretch along x.
            const auto visit = [&](std::size_t row, int shift, double across2) {
                const double room2 = support * support * (1 + 1e-6) - across2;
                if (room2 <= 0)
                    return;
                const double reach = std::sqrt(room2) + 1e-6 * support;
                const int low = grid.cell(0, at[0] - reach), high = grid.cell(0, at[0] + reach), n = grid.n(0);
                const auto stretch = [&](int from, int to, int period) {
                    const int image = shift + (period == 0 ? 0 : period > 0 ? 1 : 2);
                    Real seen[dim];
                    for (int d = 0; d < dim; ++d)
                        seen[d] = static_cast<Real>(at[d] - image_step(image, d) * grid.length(d));
                    detail::append_runs<width, dim, Real>(
                        runs, sources, seen, support2, table.start(row * row_length + static_cast<std::size_t>(from)),
                        table.start(row * row_length + static_cast<std::size_t>(to) + 1), image);
                };
                // The part of [low, high] that lies in the grid, seen directly or one period further on or back.
                const auto part = [&](int moved, int period) {
                    const int from = std::max(low + moved, 0), to = std::min(high + moved, n - 1);
                    if (from <= to)
                        stretch(from, to, period);
                };
                if (grid.wraps(0) && low < 0)
                    part(n, -1);
                part(0, 0);
                if (grid.wraps(0) && high >= n)
                    part(-n, 1);
            };
            // The rows around, direction by direction; `weight` is 3^d, the value of a step in the image number.
            const auto around = [&](int d, const auto& next) {
                const int centre = grid.cell(d, at[d]), n = grid.n(d);
                for (int k = -1; k <= 1; ++k) {
                    int c = centre + k, step = 0;
                    if (c < 0 || c >= n) {
                        if (!grid.wraps(d)) {
                            continue;
                        }
                        step = c < 0 ? -1 : 1;
                        c -= step * n;
                        if (c < 0 || c >= n)
                            continue;
                    }
                    const double low = grid.lower(d) + (centre + k) * grid.width(d);
                    const double gap = std::max({low - at[d], at[d] - low - grid.width(d), 0.0});
                    next(static_cast<std::size_t>(c), step == 0 ? 0 : step > 0 ? 1 : 2, gap * gap);
                }
            };
            if constexpr (dim == 2) {
                around(1, [&](std::size_t y, int image, double gap2) { visit(y, 3 * image, gap2); });
            } else {
                around(2, [&](std::size_t z, int image_z, double gap_z) {
                    around(1, [&](std::size_t y, int image_y, double gap_y) {
                        visit(z * static_cast<std::size_t>(grid.n(1)) + y, 3 * image_y + 9 * image_z, gap_y + gap_z);
                    });
                });
            }
            list.finish(i);
        }
    });
}

} // namespace imbibe::search
