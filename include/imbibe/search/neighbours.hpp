// Builds the runs of neighbours of one set of points in another.
#pragma once

#include <imbibe/search/reach.hpp>
#include <imbibe/search/runs.hpp>

#include <bit>
#include <utility>

namespace imbibe::search {

namespace detail {

// Writes the runs of one particle's neighbours among at most 64 particles [begin, end) of the sorted order: at most one
// run per `width` of them, with room for two more. Returns the place after the last one.
//
// The number of neighbours differs from row to row, and a branch on it would be mispredicted every other time. So a row
// of the usual length is compared as a whole, and its first runs are written whether they exist or not.
template <int width, int dim, class Real>
IMBIBE_INLINE Run* append_runs(Run* to, const std::array<const Real*, static_cast<std::size_t>(dim)>& sources,
                               const Vector<Pack<Real, width>, dim>& at, Pack<Real, width> support2,
                               std::uint32_t begin, std::uint32_t end, std::uint32_t stop) {
    static_assert(width <= static_cast<int>(Run::most_neighbours), "imbibe: a run has room for the count of 16");
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
        *to = {first, std::min(lanes, stop - first)};
        to += hits != 0;
        hits &= ~(one_run << (skip & 63));
    };
    write();
    write();
    while (hits != 0)
        write();
    return to;
}

/// Writes the runs of one stretch of any length, 64 particles at a time: at most one for each `width` of them and one
/// more, with room for two. Returns the place after the last one.
template <int width, int dim, class Real>
Run* append_long_stretch(Run* to, const std::array<const Real*, static_cast<std::size_t>(dim)>& sources,
                         const Vector<Pack<Real, width>, dim>& at, Pack<Real, width> support2, std::uint32_t begin,
                         std::uint32_t end) {
    for (std::uint32_t from = begin; from < end;) {
        const std::uint32_t until = std::min(from + 64, end);
        Run* const before = to;
        to = append_runs<width, dim, Real>(to, sources, at, support2, from, until, end);
        from = until;
        if (to != before) // the last run may go on
            from = std::max(from, static_cast<std::uint32_t>(to[-1].first() + to[-1].count()));
    }
    return to;
}

/// Calls use(begin, end, image) for every stretch of particles within reach of particle k of `places`, with the
/// periodic image through which it is seen, also where rows continue beyond their ends.
template <int dim, class Use>
void across_ends(const Grid<dim>& grid, const CellTable& table, const RowsAround<dim>& rows,
                 const PlacesInCells<dim>& places, std::size_t k, double support, const Use& use) {
    for (const int part : {0, 2, 1}) // the domain itself, then the images across its two ends along x
        for (std::size_t r = 0; r < rows.size; ++r) {
            const Row& row = rows.list[r];
            const int n = grid.n(0), by = part == 0 ? 0 : part == 2 ? n : -n;
            const Reach<Pack<float, 1>, dim> reach(places, k, row, support);
            const int own = places.cell[0][k] - reach.before + by;
            const int low = std::max(own + static_cast<int>(static_cast<float>(reach.low)), 0),
                      high = std::min(own + static_cast<int>(static_cast<float>(reach.high)), n);
            if (low < high)
                use(table.start(row.first_cell + static_cast<std::uint32_t>(low)),
                    table.start(row.first_cell + static_cast<std::uint32_t>(high)), row.image + part);
        }
}

/// The runs of the targets of one block, as `find_runs` has them.
template <int width, int dim, class Real>
class IMBIBE_PER_BUILD RunsOfBlock {
public:
    RunsOfBlock(RunList& run_list, int block, const Points<dim, Real>& targets, const Points<dim, Real>& sources,
                const Grid<dim>& grid, const CellTable& cell_table, double support_radius)
        : list(run_list), runs(run_list.block(block)), target_x(targets.x), source_x(sources.x), cells(grid),
          table(cell_table), support(support_radius / grid.width(0)),
          support2(static_cast<Real>(support_radius * support_radius)), among_others(targets.x != sources.x),
          in_block(std::min(list.block_size(), targets.n - block * list.block_size())), nobody(support) {}

    /// The runs of targets [begin, end), at most PlacesInCells::most.
    void find(int begin, int end) {
        const auto n = static_cast<std::size_t>(end - begin);
        std::array<const Real*, static_cast<std::size_t>(dim)> at;
        for (std::size_t d = 0; d < at.size(); ++d) {
            at[d] = target_x[d] + begin;
            if (const int k = static_cast<int>(d); cells.length(k) > 0) {
                for (std::size_t i = 0; i < n; ++i)
                    wrapped[d][i] =
                        into_period(at[d][i], static_cast<Real>(cells.lower(k)), static_cast<Real>(cells.length(k)));
                at[d] = wrapped[d];
            }
        }
        places.take(cells, at, n);
        for (std::size_t k = 0; k < n;) {
            const std::size_t first = k;
            const auto row_of = [&](std::size_t i) {
                return std::pair(places.cell[1][i], dim == 3 ? places.cell[dim - 1][i] : 0);
            };
            const auto row = row_of(first);
            while (k < n && row_of(k) == row) // sorted targets are often in the same row as the one before
                ++k;
            if (row != last_row) {
                rows = RowsAround<dim>(cells, table, row.first, row.second);
                nobody.forget();
                last_row = row;
            }
            in_reach.find(places, first, k, rows, cells.n(0), support);
            for (std::size_t i = first; i < k; ++i) {
                if (rows.size != 0 && !(among_others && nobody.is_near(cells, table, rows, places.cell[0][i])))
                    append(at, i);
                list.finish(begin + static_cast<int>(i), static_cast<std::uint32_t>(used));
                ++finished;
            }
        }
    }

private:
    static constexpr std::size_t room = RowsAround<dim>::most * (64 / width + 3); ///< for the usual short stretches
    RunList& list;
    RunList::Block& runs;
    std::array<const Real*, static_cast<std::size_t>(dim)> target_x, source_x;
    const Grid<dim> cells; // a copy, which writing runs cannot change
    const CellTable& table;
    const double support; ///< in cells along x
    const Pack<Real, width> support2;
    const bool among_others; ///< no particle is alone in its own set
    const int in_block;      ///< how many targets
    std::size_t used = 0;    ///< of `runs`
    int finished = 0;        ///< how many targets are done
    RowsAround<dim> rows;
    std::pair<int, int> last_row{-1000000000, 0};
    Nobody<dim> nobody;
    PlacesInCells<dim> places;
    CellsInReach<dim> in_reach;
    Real wrapped[static_cast<std::size_t>(dim)][PlacesInCells<dim>::most];

    // Makes room for this many runs now, and for the estimated number of the whole block.
    void make_room(std::size_t needed) {
        if (finished < 64) {
            needed *= 2;
        } else {
            const double expected = 1.1 * static_cast<double>(used) * in_block / finished + static_cast<double>(room);
            needed = std::max(needed + needed / 10, static_cast<std::size_t>(expected));
        }
        runs.reserve(needed); // resize alone would double the capacity
        runs.resize(needed);
    }

    // The runs of target k of `places`, which is at at[d][k].
    IMBIBE_INLINE void append(const std::array<const Real*, static_cast<std::size_t>(dim)>& at, std::size_t k) {
        using T = Pack<Real, width>;
        const int margin = static_cast<int>(support) + 2, own = places.cell[0][k];
        const std::size_t before = used;
        const auto append_any = [&](std::uint32_t from, std::uint32_t until, int image) {
            if (from == until)
                return;
            Vector<T, dim> seen;
            for (int d = 0; d < dim; ++d)
                seen[d] = T(static_cast<Real>(static_cast<double>(at[static_cast<std::size_t>(d)][k]) -
                                              image_step(image, d) * cells.length(d)));
            const std::size_t needed = used + (until - from) / static_cast<unsigned>(width) + room;
            if (needed > runs.size())
                make_room(needed);
            Run* const begin = runs.data() + used;
            used += static_cast<std::size_t>(
                append_long_stretch<width, dim, Real>(begin, source_x, seen, support2, from, until) - begin);
        };
        const auto append_marked = [&](std::uint32_t from, std::uint32_t until, int image) {
            const bool again = used != before && runs[used - 1] == Run::mark_of(image);
            used -= again; // the mark comes behind these as well
            const std::size_t had = used;
            append_any(from, until, image);
            if (again || used != had)
                runs[used++] = Run::mark_of(image); // `room` is for more than the runs
        };
        if (cells.wraps(0) && (own < margin || own + margin >= cells.n(0))) [[unlikely]] {
            across_ends(cells, table, rows, places, k, support, append_marked);
            return;
        }
        if (rows.shifted) [[unlikely]] {
            for (std::size_t r = 0; r < rows.size; ++r)
                append_marked(table.start(in_reach.from[r][k]), table.start(in_reach.to[r][k]), rows.list[r].image);
            return;
        }
        struct Stretch {
            std::uint32_t begin, end;
        } stretches[RowsAround<dim>::most + 1]; // one more is written that does not count
        std::size_t count = 0;
        for (std::size_t r = 0; r < rows.size; ++r) {
            const Stretch s{table.start(in_reach.from[r][k]), table.start(in_reach.to[r][k])};
            stretches[count] = s;
            count += s.begin < s.end; // without a branch: whether a row at the rim is reached is random
        }
        if (used + room > runs.size()) [[unlikely]]
            make_room(used + room);
        Vector<T, dim> here;
        for (int d = 0; d < dim; ++d)
            here[d] = T(at[static_cast<std::size_t>(d)][k]);
        const auto sources = source_x; // copies, which writing runs cannot change: they stay in registers
        const T near2 = support2;
        Run* to = runs.data() + used;
        for (const Stretch* s = stretches; s != stretches + count; ++s)
            if (s->end - s->begin <= 64) [[likely]] {
                to = append_runs<width, dim, Real>(to, sources, here, near2, s->begin, s->end, s->end);
            } else {
                used = static_cast<std::size_t>(to - runs.data());
                append_any(s->begin, s->end, 0);
                to = runs.data() + used;
            }
        used = static_cast<std::size_t>(to - runs.data());
    }
};

} // namespace detail

/// For every target point, the runs of source points nearer than `support`. The sources are in the order of `table`.
/// Runs may hold points beyond the support as well: compact kernels give them zero. Targets outside a periodic box
/// (those of a total-Lagrangian phase are not wrapped) are moved into it first, so the images of their runs are those
/// seen from there; the pair loop does the same. Throws Error for more sources than `Run::most_particles`.
template <int width, int dim, class Real>
void find_runs(RunList& list, const Points<dim, Real>& targets, const Points<dim, Real>& sources, const Grid<dim>& grid,
               const CellTable& table, double support, int threads) {
    require(static_cast<std::uint32_t>(sources.n) <= Run::most_particles, "a phase or set has ", sources.n,
            " particles; it must have at most ", Run::most_particles, ". Make two of it, or space them wider");
    list.resize(targets.n, threads);
    parallel_for(list.block_count(), threads, [&](int block) {
        constexpr int at_once = static_cast<int>(detail::PlacesInCells<dim>::most);
        detail::RunsOfBlock<width, dim, Real> runs(list, block, targets, sources, grid, table, support);
        const int begin = block * list.block_size(), end = begin + std::min(targets.n - begin, list.block_size());
        for (int i = begin; i < end; i += at_once)
            runs.find(i, std::min(i + at_once, end));
    });
    list.finish();
}

} // namespace imbibe::search
