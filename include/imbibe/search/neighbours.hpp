// Builds the runs of neighbours of one set of points in another.
#pragma once

#include <imbibe/core/vector.hpp>
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

// Writes the runs of one particle's neighbours among the particles [begin, end) of the sorted order; at most one run
// per `width` of them. Returns the place after the last one.
template <int width, int dim, class Real>
IMBIBE_INLINE Run* append_runs(Run* to, const Points<dim, Real>& sources, const Vector<Real, dim>& at, Real support2,
                               std::uint32_t begin, std::uint32_t end, int image) {
    using T = Pack<Real, width>;
    for (std::uint32_t j = begin; j < end;) {
        T distance2(0);
        for (int d = 0; d < dim; ++d)
            distance2 += sq(T(at[d]) - T::load(sources.x[static_cast<std::size_t>(d)] + j));
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
        *to++ = {first, static_cast<std::uint16_t>(count), static_cast<std::uint16_t>(image)};
        j = first + static_cast<std::uint32_t>(width);
    }
    return to;
}

/// One of the rows of cells around a particle: where it begins in the cell table, its periodic image, and which of
/// the steps -1, 0, 1 along y and z lead there.
struct NearRow {
    std::size_t first_cell;
    int image, step_y, step_z;
};

/// The rows around the cell (y, z) of a grid that are not empty; in two dimensions z is 0 and there are no rows above
/// and below.
template <int dim>
int near_rows(const Grid<dim>& grid, const CellTable& table, int y, int z, NearRow (&rows)[9]) {
    // The cell that step k leads to along d and the digit of its periodic image; -1 where there is none.
    const auto around = [&](int d, int c, int& image) {
        image = 0;
        const int n = grid.n(d);
        if (c >= 0 && c < n)
            return c;
        if (!grid.wraps(d))
            return -1;
        image = c < 0 ? 2 : 1;
        c += c < 0 ? n : -n;
        return c >= 0 && c < n ? c : -1;
    };
    int count = 0;
    for (int step_z = dim == 3 ? -1 : 0; step_z <= (dim == 3 ? 1 : 0); ++step_z) {
        int image_z = 0, cell_z = 0;
        if constexpr (dim == 3)
            cell_z = around(2, z + step_z, image_z);
        for (int step_y = -1; step_y <= 1; ++step_y) {
            int image_y = 0;
            const int cell_y = around(1, y + step_y, image_y);
            if (cell_y < 0 || cell_z < 0)
                continue;
            const std::size_t row =
                static_cast<std::size_t>(cell_z) * static_cast<std::size_t>(grid.n(1)) + static_cast<std::size_t>(cell_y);
            const std::size_t first = row * static_cast<std::size_t>(grid.n(0));
            if (table.start(first) != table.start(first + static_cast<std::size_t>(grid.n(0))))
                rows[count++] = {first, 3 * image_y + 9 * image_z, step_y, step_z};
        }
    }
    return count;
}

/// The squares of the distances from x to the cells below, at and above cell c along d.
template <int dim>
IMBIBE_INLINE void gaps(const Grid<dim>& grid, int d, int c, double x, double (&gap2)[3]) {
    const double low = grid.lower(d) + c * grid.width(d);
    const double below = std::max(x - low, 0.0), above = std::max(low + grid.width(d) - x, 0.0);
    gap2[0] = below * below;
    gap2[1] = 0;
    gap2[2] = above * above;
}

} // namespace detail

/// For every target point, the runs of source points nearer than `support`. The sources are in the order of `table`.
/// Runs may hold points beyond the support as well: compact kernels give them zero. Targets outside a periodic box
/// (those of a total-Lagrangian phase are not wrapped) are moved into it first, so the images of their runs are those
/// seen from there; the pair loop does the same.
template <int width, int dim, class Real>
void find_runs(RunList& list, const Points<dim, Real>& targets, const Points<dim, Real>& sources,
               const Grid<dim>& grid, const CellTable& table, double support, int threads) {
    list.resize(targets.n);
    const Real support2 = static_cast<Real>(support * support);
    const int n = grid.n(0);
    const auto place = [&](Real x, int d) {
        return grid.wraps(d) ? into_period(x, static_cast<Real>(grid.lower(d)), static_cast<Real>(grid.length(d))) : x;
    };
    const double per_cell = 1 / grid.width(0), slack = 1e-6 * support;
    parallel_for(list.block_count(), threads, [&](int block) {
        std::vector<Run>& runs = list.block(block);
        Run* to = runs.data();
        detail::NearRow rows[9];
        int row_count = 0, row_y = -1000000000, row_z = 0;
        const int end = std::min(targets.n, (block + 1) * RunList::block_size);
        for (int i = block * RunList::block_size; i < end; ++i) {
            double at[3] = {};
            for (int d = 0; d < dim; ++d)
                at[d] = static_cast<double>(place(targets.x[static_cast<std::size_t>(d)][i], d));
            const int y = grid.cell(1, at[1]), z = dim == 3 ? grid.cell(dim - 1, at[dim - 1]) : 0;
            if (y != row_y || z != row_z) { // sorted targets share their rows with the one before
                row_count = detail::near_rows(grid, table, y, z, rows);
                row_y = y;
                row_z = z;
            }
            if (row_count == 0) {
                list.finish(i, static_cast<std::uint32_t>(to - runs.data()));
                continue;
            }
            double gap2_y[3], gap2_z[3] = {};
            detail::gaps(grid, 1, y, at[1], gap2_y);
            if constexpr (dim == 3)
                detail::gaps(grid, 2, z, at[2], gap2_z);
            const double x = (at[0] - grid.lower(0)) * per_cell;
            for (int r = 0; r < row_count; ++r) {
                const detail::NearRow& row = rows[r];
                const double room2 = support * support - gap2_y[row.step_y + 1] - gap2_z[row.step_z + 1];
                if (room2 < -slack * support)
                    continue;
                const double reach = (std::sqrt(std::max(room2, 0.0)) + slack) * per_cell;
                const int low = static_cast<int>(std::floor(x - reach)), high = static_cast<int>(std::floor(x + reach));
                const auto stretch = [&](int from, int to_cell, int image) {
                    const std::uint32_t begin = table.start(row.first_cell + static_cast<std::size_t>(from));
                    const std::uint32_t stop = table.start(row.first_cell + static_cast<std::size_t>(to_cell) + 1);
                    const auto used = static_cast<std::size_t>(to - runs.data());
                    const std::size_t most = used + (stop - begin) / static_cast<std::uint32_t>(width) + 1;
                    if (most > runs.size()) {
                        runs.resize(2 * most);
                        to = runs.data() + used;
                    }
                    Vector<Real, dim> seen;
                    for (int d = 0; d < dim; ++d)
                        seen[d] = static_cast<Real>(image == 0 ? at[d] : at[d] - image_step(image, d) * grid.length(d));
                    to = detail::append_runs<width, dim, Real>(to, sources, seen, support2, begin, stop, image);
                };
                if (low < n && high >= 0)
                    stretch(std::max(low, 0), std::min(high, n - 1), row.image);
                if (grid.wraps(0)) {
                    if (low < 0)
                        stretch(std::max(low + n, 0), n - 1, row.image + 2);
                    if (high >= n)
                        stretch(0, std::min(high - n, n - 1), row.image + 1);
                }
            }
            list.finish(i, static_cast<std::uint32_t>(to - runs.data()));
        }
    });
}

} // namespace imbibe::search
