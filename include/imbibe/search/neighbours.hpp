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

// Writes the runs of one particle's neighbours among at most 64 particles [begin, end) of the sorted order; at most one
// run per `width` of them, and room for two more. Returns the place after the last one.
//
// How many are near differs from row to row, and a branch on it would be mispredicted every other time. So a row of
// the usual length is compared as a whole and its first runs are written whether they are there or not.
template <int width, int dim, class Real>
IMBIBE_INLINE Run* append_runs(Run* to, const std::array<const Real*, static_cast<std::size_t>(dim)>& sources,
                               const Vector<Pack<Real, width>, dim>& at, Pack<Real, width> support2,
                               std::uint32_t begin, std::uint32_t end, std::uint32_t stop, int image) {
    using T = Pack<Real, width>;
    constexpr std::uint32_t usual = 32, lanes = static_cast<std::uint32_t>(width);
    constexpr std::uint64_t one_run = (std::uint64_t(1) << lanes) - 1;
    std::uint64_t hits = 0;
    const auto compare = [&](std::uint32_t k) {
        T distance2 = sq(at[0] - T::load(sources[0] + begin + k));
        for (int d = 1; d < dim; ++d)
            distance2 += sq(at[d] - T::load(sources[static_cast<std::size_t>(d)] + begin + k));
        hits |= static_cast<std::uint64_t>(less_bits(distance2, support2)) << k;
    };
    for (std::uint32_t k = 0; k < usual; k += lanes)
        compare(k);
    for (std::uint32_t k = usual; k < end - begin; k += lanes)
        compare(k);
    hits &= ~std::uint64_t(0) >> (64 - (end - begin));
    const auto write = [&] {
        const auto skip = static_cast<std::uint32_t>(std::countr_zero(hits));
        const std::uint32_t first = begin + skip;
        const std::uint32_t count = std::min(lanes, stop - first);
        *to = {first, static_cast<std::uint16_t>(count), static_cast<std::uint16_t>(image)};
        to += hits != 0;
        hits &= ~(one_run << (skip & 63));
    };
    write();
    write();
    while (hits != 0)
        write();
    return to;
}

/// The rows of cells around one row, itself included: 9 in space, 3 in the plane. Row r is `step_y(r)` and `step_z(r)`
/// rows away. The particle's own row is the last one, so that the eight others in space are whole packs.
template <int dim>
struct RowsAround {
    static constexpr int count = dim == 3 ? 9 : 3, own = count - 1, room = 16;
    /// The k-th row in the order of the sorted particles.
    static constexpr int in_order(int k) { return k == count / 2 ? own : k - (k > count / 2 ? 1 : 0); }
    static constexpr int step_y(int r) { return place(r) % 3 - 1; }
    static constexpr int step_z(int r) { return dim == 3 ? place(r) / 3 - 1 : 0; }

    std::array<std::int32_t, room> cells{};       ///< how many cells the row has; 0: it is empty, or there is none
    std::array<std::uint32_t, room> first_cell{}; ///< where it begins in the cell table
    std::array<int, room> image{};                ///< the periodic image it is seen through
    bool any = false;                             ///< is one of them not empty?
    bool shifted = false;                         ///< is one of them seen through a periodic image?

    RowsAround() = default;
    /// The rows around row (y, z) of a grid.
    RowsAround(const Grid<dim>& grid, const CellTable& table, int y, int z) {
        // The cell c of direction d and the digit of its periodic image; -1 where there is none.
        const auto around = [&](int d, int c, int& digit) {
            digit = 0;
            const int n = grid.n(d);
            if (c >= 0 && c < n)
                return c;
            if (!grid.wraps(d))
                return -1;
            digit = c < 0 ? 2 : 1;
            c += c < 0 ? n : -n;
            return c >= 0 && c < n ? c : -1;
        };
        const auto n = static_cast<std::uint32_t>(grid.n(0));
        for (int r = 0; r < count; ++r) {
            int image_y = 0, image_z = 0, cell_z = 0;
            const int cell_y = around(1, y + step_y(r), image_y);
            if constexpr (dim == 3)
                cell_z = around(2, z + step_z(r), image_z);
            if (cell_y < 0 || cell_z < 0)
                continue;
            const auto k = static_cast<std::size_t>(r);
            first_cell[k] = (static_cast<std::uint32_t>(cell_z) * static_cast<std::uint32_t>(grid.n(1)) +
                             static_cast<std::uint32_t>(cell_y)) *
                            n;
            image[k] = 3 * image_y + 9 * image_z;
            const bool holds_some = table.start(first_cell[k]) != table.start(first_cell[k] + n);
            cells[k] = holds_some ? grid.n(0) : 0;
            any = any || holds_some;
            shifted = shifted || image[k] != 0;
        }
    }

    /// Do the cells from `low` up to, not including, `high` along x hold nothing in any row?
    bool are_empty(const CellTable& table, int low, int high) const {
        for (std::size_t r = 0; r < count; ++r) {
            const int from = std::clamp(low, 0, cells[r]), to = std::clamp(high, 0, cells[r]);
            if (table.start(first_cell[r] + static_cast<std::uint32_t>(from)) !=
                table.start(first_cell[r] + static_cast<std::uint32_t>(to)))
                return false;
        }
        return true;
    }

private:
    static constexpr int place(int r) { return r == own ? count / 2 : r + (r >= count / 2 ? 1 : 0); }
};

/// Where along x the rows around hold nobody within reach. Most particles of a wall find so in the water, and most of
/// the water in the wall; sorted by cells they find it together.
template <int dim>
class Nobody {
public:
    /// @param support in cells along x
    explicit Nobody(double support) : reach(static_cast<int>(std::ceil(support)) + 2) {}

    /// For other rows.
    void forget() { end = begin; }

    /// Is nobody within reach of a particle in cell `own`, counted along x? False where that is not certain.
    bool is_near(const Grid<dim>& grid, const CellTable& table, const RowsAround<dim>& rows, int own) {
        constexpr int asked_at_once = 4; // half a support
        if (own < begin || own >= end) {
            begin = own;
            end = own + asked_at_once;
            const int low = begin - reach, high = end + reach;
            certain = (!grid.wraps(0) || (low >= 0 && high <= grid.n(0))) && rows.are_empty(table, low, high);
        }
        return certain;
    }

private:
    int reach, begin = 0, end = 0; ///< the cells along x that were asked for
    bool certain = false;
};

/// How far the support of a particle reaches in each of the rows around it: from cell low[r] up to, not including, cell
/// high[r], counted along x from `before` cells before the particle's own. low[r] >= high[r] where it does not reach the
/// row.
template <int dim>
struct IMBIBE_PER_BUILD Reach {
    static constexpr int before = 64; ///< makes the numbers positive, so that truncation is downwards
    std::array<std::int32_t, RowsAround<dim>::room> low, high;

    /// @param x where the particle stands in its own cell, from 0 to 1
    /// @param below the distances along y and z to the rows below, in cells along x
    /// @param above those to the rows above
    /// @param support in cells along x
    IMBIBE_INLINE Reach(double x, const std::array<double, 2>& below, const std::array<double, 2>& above,
                        double support) {
        // In float: the numbers are small, and what rounding could lose the slack gives back.
        using T = Pack<float, native_width<float>>;
        using Rows = RowsAround<dim>;
        constexpr double slack = 1e-4;
        static constexpr Weights weights;
        const auto square = [](double gap) { return sq(T(static_cast<float>(std::min(gap, 1e9)))); }; // not infinite
        const float room2 = static_cast<float>(sq(support) * (1 + 1e-5));
        const float least = static_cast<float>(x + before - slack), most = static_cast<float>(x + before + 1 + slack);
        const T y0 = square(below[0]), y1 = square(above[0]), z0 = square(below[1]), z1 = square(above[1]);
        for (int r = 0; r < Rows::own; r += T::size) {
            const T rest = T(room2) - T::load(weights.y_below + r) * y0 - T::load(weights.y_above + r) * y1 -
                           T::load(weights.z_below + r) * z0 - T::load(weights.z_above + r) * z1;
            const T half = sqrt(positive_part(rest));
            truncate(T(least) - half, low.data() + r);
            truncate(select(rest < T(0), T(0), T(most) + half), high.data() + r);
        }
        constexpr std::size_t own = Rows::own;
        if constexpr (Rows::own % T::size == 0) { // no pack has reached it
            const float half = sqrt(room2);
            low[own] = static_cast<std::int32_t>(least - half);
            high[own] = static_cast<std::int32_t>(most + half);
        }
    }

private:
    struct Weights {
        float y_below[RowsAround<dim>::room]{}, y_above[RowsAround<dim>::room]{}, z_below[RowsAround<dim>::room]{},
            z_above[RowsAround<dim>::room]{};
        constexpr Weights() {
            for (int r = 0; r < RowsAround<dim>::count; ++r) {
                y_below[r] = RowsAround<dim>::step_y(r) < 0;
                y_above[r] = RowsAround<dim>::step_y(r) > 0;
                z_below[r] = RowsAround<dim>::step_z(r) < 0;
                z_above[r] = RowsAround<dim>::step_z(r) > 0;
            }
        }
    };
};

/// The particles [begin, end) of the sorted order, where neighbours may be.
struct Stretch {
    std::uint32_t begin, end;
};

/// The stretches that the support of one particle reaches: at most three a row.
template <int dim>
struct Stretches {
    static constexpr std::size_t most = 3 * RowsAround<dim>::count + 1; // one is written that does not count
    Stretch list[most];
    int image[most]; ///< the image each is seen through; not set where none is
    std::size_t count = 0;
    bool plain; ///< none is seen through a periodic image

    /// What `reach` covers of `rows`.
    /// @param own the particle's own cell along x
    IMBIBE_INLINE Stretches(const Grid<dim>& grid, const CellTable& table, const RowsAround<dim>& rows,
                            const Reach<dim>& reach, int own) {
        own -= Reach<dim>::before;
        constexpr std::size_t farthest = RowsAround<dim>::own; // nowhere does it reach farther along x
        const bool across = grid.wraps(0) && (own + reach.low[farthest] < 0 || own + reach.high[farthest] > grid.n(0));
        plain = !across && !rows.shifted;
        if (!plain) [[unlikely]] {
            see_through_images(grid, table, rows, reach, own);
            return;
        }
        std::array<std::uint32_t, RowsAround<dim>::count> from, to;
        for (std::size_t r = 0; r < from.size(); ++r) {
            const int low = std::min(std::max(own + reach.low[r], 0), rows.cells[r]);
            const int high = std::min(std::max(own + reach.high[r], low), rows.cells[r]);
            from[r] = rows.first_cell[r] + static_cast<std::uint32_t>(low);
            to[r] = rows.first_cell[r] + static_cast<std::uint32_t>(high);
        }
        for (int k = 0; k < RowsAround<dim>::count; ++k) {
            const auto r = static_cast<std::size_t>(RowsAround<dim>::in_order(k));
            const Stretch s{table.start(from[r]), table.start(to[r])};
            list[count] = s;
            count += s.begin < s.end; // without a branch: whether a row at the rim is reached is a matter of chance
        }
    }

private:
    void see_through_images(const Grid<dim>& grid, const CellTable& table, const RowsAround<dim>& rows,
                            const Reach<dim>& reach, int own) {
        for (const int part : {0, 2, 1}) // the domain itself, then what lies across its two ends along x
            for (int k = 0; k < RowsAround<dim>::count; ++k) {
                const auto r = static_cast<std::size_t>(RowsAround<dim>::in_order(k));
                const int n = rows.cells[r], by = part == 0 || !grid.wraps(0) ? 0 : part == 2 ? n : -n;
                if (part != 0 && by == 0)
                    continue;
                const int low = std::max(own + reach.low[r] + by, 0), high = std::min(own + reach.high[r] + by, n);
                if (low >= high)
                    continue;
                const std::uint32_t begin = table.start(rows.first_cell[r] + static_cast<std::uint32_t>(low)),
                                    end = table.start(rows.first_cell[r] + static_cast<std::uint32_t>(high));
                list[count] = {begin, end};
                image[count] = rows.image[r] + part;
                count += begin < end;
            }
    }
};

/// Writes the runs of one stretch of any length, 64 particles at a time; at most one for each `width` of them and one
/// more, and room for two. Returns the place after the last one.
template <int width, int dim, class Real>
Run* append_long_stretch(Run* to, const std::array<const Real*, static_cast<std::size_t>(dim)>& sources,
                         const Vector<Pack<Real, width>, dim>& at, Pack<Real, width> support2, const Stretch& s,
                         int image) {
    for (std::uint32_t from = s.begin; from < s.end;) {
        const std::uint32_t until = std::min(from + 64, s.end);
        Run* const before = to;
        to = append_runs<width, dim, Real>(to, sources, at, support2, from, until, s.end, image);
        from = to == before ? until : std::max(until, to[-1].first + to[-1].count); // the last run may go on
    }
    return to;
}

} // namespace detail

/// For every target point, the runs of source points nearer than `support`. The sources are in the order of `table`.
/// Runs may hold points beyond the support as well: compact kernels give them zero. Targets outside a periodic box
/// (those of a total-Lagrangian phase are not wrapped) are moved into it first, so the images of their runs are those
/// seen from there; the pair loop does the same.
template <int width, int dim, class Real>
void find_runs(RunList& list, const Points<dim, Real>& targets, const Points<dim, Real>& sources, const Grid<dim>& grid,
               const CellTable& table, double support, int threads) {
    list.resize(targets.n);
    const double per_cell = 1 / grid.width(0);
    using T = Pack<Real, width>;
    const auto source_x = sources.x;
    const bool among_others = targets.x != source_x; // nobody is alone in his own set
    parallel_for(list.block_count(), threads, [&](int block) {
        constexpr std::size_t room = detail::RowsAround<dim>::count * (64 / width + 3); // for the usual short stretches
        const Grid<dim> cells = grid; // a copy, which writing runs cannot change: it stays in registers
        bool periodic = false;
        for (int d = 0; d < dim; ++d)
            periodic = periodic || cells.wraps(d);
        const auto place = [&](int i, int d) {
            const Real x = targets.x[static_cast<std::size_t>(d)][i];
            return static_cast<double>(periodic && cells.wraps(d) ? into_period(x, static_cast<Real>(cells.lower(d)),
                                                                                static_cast<Real>(cells.length(d)))
                                                                  : x);
        };
        const T support2(static_cast<Real>(support * support));
        std::vector<Run>& runs = list.block(block);
        std::size_t used = 0;
        detail::RowsAround<dim> rows;
        detail::Nobody<dim> nobody(support * per_cell);
        int row_y = -1000000000, row_z = 0;
        const int end = std::min(targets.n, (block + 1) * RunList::block_size);
        for (int i = block * RunList::block_size; i < end; ++i) {
            std::array<double, 3> at{};
            for (int d = 0; d < dim; ++d)
                at[static_cast<std::size_t>(d)] = place(i, d);
            const int y = cells.cell(1, at[1]), z = dim == 3 ? cells.cell(dim - 1, at[dim - 1]) : 0;
            if (y != row_y || z != row_z) { // sorted targets share their rows with the one before
                rows = detail::RowsAround<dim>(cells, table, y, z);
                nobody.forget();
                row_y = y;
                row_z = z;
            }
            const double x = (at[0] - cells.lower(0)) * per_cell, cell = std::floor(x);
            if (!rows.any || (among_others && nobody.is_near(cells, table, rows, static_cast<int>(cell)))) {
                list.finish(i, static_cast<std::uint32_t>(used));
                continue;
            }
            std::array<double, 2> below{}, above{};
            for (int d = 1; d < dim; ++d) {
                const double from = at[static_cast<std::size_t>(d)] - cells.lower(d) - (d == 1 ? y : z) * cells.width(d);
                below[static_cast<std::size_t>(d - 1)] = std::max(from, 0.0) * per_cell;
                above[static_cast<std::size_t>(d - 1)] = std::max(cells.width(d) - from, 0.0) * per_cell;
            }
            const detail::Stretches<dim> stretches(cells, table, rows,
                                                   detail::Reach<dim>(x - cell, below, above, support * per_cell),
                                                   static_cast<int>(cell));
            if (used + room > runs.size()) [[unlikely]]
                runs.resize(2 * (used + room));
            Vector<T, dim> here;
            for (int d = 0; d < dim; ++d)
                here[d] = T(static_cast<Real>(at[static_cast<std::size_t>(d)]));
            Run* to = runs.data() + used;
            for (std::size_t k = 0; k < stretches.count; ++k) {
                const detail::Stretch s = stretches.list[k];
                if (stretches.plain && s.end - s.begin <= 64) [[likely]] {
                    to = detail::append_runs<width, dim, Real>(to, source_x, here, support2, s.begin, s.end, s.end, 0);
                } else {
                    const int image = stretches.plain ? 0 : stretches.image[k];
                    Vector<T, dim> seen;
                    for (int d = 0; d < dim; ++d)
                        seen[d] = T(static_cast<Real>(at[static_cast<std::size_t>(d)] -
                                                      image_step(image, d) * cells.length(d)));
                    used = static_cast<std::size_t>(to - runs.data());
                    const std::size_t needed = used + (s.end - s.begin) / static_cast<unsigned>(width) + room;
                    if (needed > runs.size()) [[unlikely]]
                        runs.resize(2 * needed);
                    to = detail::append_long_stretch<width, dim, Real>(runs.data() + used, source_x, seen, support2, s,
                                                                       image);
                }
            }
            used = static_cast<std::size_t>(to - runs.data());
            list.finish(i, static_cast<std::uint32_t>(used));
        }
    });
    list.finish();
}

} // namespace imbibe::search
