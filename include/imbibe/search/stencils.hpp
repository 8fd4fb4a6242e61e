// Neighbours that never change, for packs of consecutive particles. Where particles are numbered row by row of a
// lattice, those around consecutive particles are consecutive as well: a pair loop computes a pack of particles with a
// pack of neighbours that it loads at once, every lane is used, and no sum runs across lanes.
#pragma once

#include <imbibe/search/neighbours.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace imbibe::search {

/// Neighbours that never change, and the order of the particles for which they are.
struct IMBIBE_PER_BUILD FixedLists {
    /// Particle order[k] belongs at k.
    std::vector<std::uint32_t> order;
    /// Of each particle.
    RunList runs;
    /// Of each pack of particles, p width, p width + 1, ...: its *stencil*, runs of as many neighbours as it has
    /// particles. Particle l of the pack and neighbour l of a run are a pair. A pair that is nearer than the support is
    /// in one run only; the others, which fill lanes, are beyond it, where every kernel is zero. A pack that is better
    /// served by the runs of its particles has no stencil.
    RunList stencils;
};

namespace detail {

/// The order row by row of a lattice with this spacing, m: the rows are along the longest side of all points.
template <int dim, class Real>
std::vector<std::uint32_t> order_in_rows(const Points<dim, Real>& points, double spacing, int threads) {
    const Bounds<dim> bounds = bounds_of(points, threads);
    std::array<std::size_t, static_cast<std::size_t>(dim)> axes; // along the rows first
    std::iota(axes.begin(), axes.end(), std::size_t{0});
    const auto length = [&](std::size_t d) { return bounds.upper[d] - bounds.lower[d]; };
    std::swap(axes[0], *std::max_element(axes.begin(), axes.end(),
                                         [&](std::size_t d, std::size_t e) { return length(d) < length(e); }));
    struct Place {
        std::array<double, static_cast<std::size_t>(dim)> key; // from the outermost to the place along the row
        std::uint32_t number;
    };
    std::vector<Place> places(static_cast<std::size_t>(points.n));
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i].number = static_cast<std::uint32_t>(i);
        for (std::size_t k = 0; k < axes.size(); ++k) {
            const double at = static_cast<double>(points.x[axes[k]][i]) - bounds.lower[axes[k]];
            places[i].key[axes.size() - 1 - k] = k == 0 ? at : std::round(at / spacing);
        }
    }
    std::sort(places.begin(), places.end(), [&](const Place& one, const Place& other) {
        if (one.key != other.key)
            return one.key < other.key;
        for (std::size_t d = 0; d < axes.size(); ++d) // two rows in one: an order that does not depend on the numbers
            if (points.x[d][one.number] != points.x[d][other.number])
                return points.x[d][one.number] < points.x[d][other.number];
        return false;
    });
    std::vector<std::uint32_t> order(places.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        order[k] = places[k].number;
    return order;
}

/// The coordinates of points in another order.
template <int dim, class Real>
class IMBIBE_PER_BUILD PointsInOrder {
public:
    PointsInOrder(const Points<dim, Real>& points, const std::vector<std::uint32_t>& order) : n_(points.n) {
        for (std::size_t d = 0; d < x_.size(); ++d) {
            x_[d].resize(order.size() + read_beyond);
            for (std::size_t k = 0; k < order.size(); ++k)
                x_[d][k] = points.x[d][order[k]];
        }
    }
    /// Valid as long as this object.
    Points<dim, Real> points() const {
        Points<dim, Real> p{.n = n_};
        for (std::size_t d = 0; d < x_.size(); ++d)
            p.x[d] = x_[d].data();
        return p;
    }

private:
    int n_;
    std::array<AlignedVector<Real>, static_cast<std::size_t>(dim)> x_;
};

/// Makes runs and stencils of particles in rows from their runs in the order of the cells.
template <int width, int dim, class Real>
class IMBIBE_PER_BUILD ListsInRows {
public:
    /// @param in_cells the points in the order of the cells, and @param runs their runs
    /// @param to_cell the place in that order of every point in rows
    ListsInRows(const Points<dim, Real>& in_cells, const RunList& runs, const std::vector<std::uint32_t>& to_cell,
                const Grid<dim>& grid, double support)
        : in_cells_(in_cells), given_(runs), to_cell_(to_cell), to_row_(to_cell.size()), grid_(grid),
          support2_(static_cast<Real>(support * support)) {
        for (std::size_t k = 0; k < to_cell.size(); ++k)
            to_row_[to_cell[k]] = static_cast<std::uint32_t>(k);
    }

    /// Finds them. @return how many packs of neighbours a loop over all particles computes
    std::size_t find(RunList& runs, RunList& stencils, int threads) {
        runs.resize(in_cells_.n, threads);
        stencils.resize((in_cells_.n + width - 1) / width, threads);
        const int block = std::max(runs.block_size(), stencils.block_size() * width); // whole blocks of both
        const int blocks = (in_cells_.n + block - 1) / block;
        std::vector<std::size_t> computed(static_cast<std::size_t>(blocks));
        parallel_for(blocks, threads, [&](int b) {
            std::vector<Neighbour> found, pattern;
            const int begin = b * block, end = begin + std::min(in_cells_.n - begin, block);
            for (int first = begin; first < end; first += width)
                computed[static_cast<std::size_t>(b)] +=
                    find_pack(runs, stencils, first, std::min(first + width, end), found, pattern);
        });
        runs.finish();
        stencils.finish();
        return std::accumulate(computed.begin(), computed.end(), std::size_t{0});
    }

private:
    struct Neighbour {
        int image;
        std::uint32_t number; // of the neighbour, or of the one in the first lane
        auto operator<=>(const Neighbour&) const = default;
    };

    const Points<dim, Real> in_cells_;
    const RunList& given_;
    const std::vector<std::uint32_t>& to_cell_;
    std::vector<std::uint32_t> to_row_;
    const Grid<dim>& grid_;
    const Real support2_;

    // The runs of particles [first, last), and their stencil. Returns how many packs of neighbours they take.
    std::size_t find_pack(RunList& runs, RunList& stencils, int first, int last, std::vector<Neighbour>& found,
                          std::vector<Neighbour>& pattern) const {
        RunList::Block& to = runs.block(first / runs.block_size());
        bool whole = last - first == width;
        const std::size_t before = to.size();
        pattern.clear();
        for (int i = first; i < last; ++i) {
            find_neighbours(i, found);
            append(to, found, [&](std::size_t& k) { // all that one run has room for
                const std::uint32_t from = found[k].number,
                                    count = std::min(static_cast<std::uint32_t>(width),
                                                     static_cast<std::uint32_t>(in_cells_.n) - from);
                const int image = found[k].image;
                while (k < found.size() && found[k].image == image && found[k].number - from < count)
                    ++k;
                return Run(from, count);
            });
            runs.finish(i, static_cast<std::uint32_t>(to.size()));
            const auto lane = static_cast<std::uint32_t>(i - first);
            for (const Neighbour& other : found) {
                const std::uint32_t from = other.number - lane;
                whole = whole && other.number >= lane && from + width <= static_cast<std::uint32_t>(in_cells_.n);
                pattern.push_back({other.image, from});
            }
        }
        std::sort(pattern.begin(), pattern.end());
        pattern.erase(std::unique(pattern.begin(), pattern.end()), pattern.end());
        const int pack = first / width;
        RunList::Block& stencil = stencils.block(pack / stencils.block_size());
        const std::size_t in_runs = to.size() - before;
        whole = whole && pattern.size() < in_runs;
        if (whole)
            append(stencil, pattern, [&](std::size_t& k) { return Run(pattern[k++].number, width); });
        stencils.finish(pack, static_cast<std::uint32_t>(stencil.size()));
        return whole ? pattern.size() : in_runs;
    }
    // The neighbours of particle i of the rows, itself included, in order.
    void find_neighbours(int i, std::vector<Neighbour>& found) const {
        found.clear();
        const std::uint32_t own = to_cell_[static_cast<std::size_t>(i)];
        given_[static_cast<int>(own)].for_each([&](Run run, int image) {
            for (std::size_t k = run.first(); k < run.first() + run.count(); ++k) {
                Real distance2 = 0;
                for (int d = 0; d < dim; ++d) {
                    const auto* const x = in_cells_.x[static_cast<std::size_t>(d)];
                    const double length = grid_.length(d);
                    const Real here =
                        length > 0 ? into_period(x[own], static_cast<Real>(grid_.lower(d)), static_cast<Real>(length))
                                   : x[own];
                    distance2 +=
                        sq(static_cast<Real>(static_cast<double>(here) - image_step(image, d) * length) - x[k]);
                }
                if (distance2 < support2_)
                    found.push_back({image, to_row_[k]});
            }
        });
        std::sort(found.begin(), found.end());
    }
    // Writes the runs that `next` makes of neighbours from number k on, moving k past them, and the marks of images.
    static void append(RunList::Block& to, const std::vector<Neighbour>& neighbours, const auto& next) {
        const bool marked = !neighbours.empty() && neighbours.back().image != 0;
        for (std::size_t k = 0; k < neighbours.size();) {
            const int image = neighbours[k].image;
            to.push_back(next(k));
            if (marked && (k == neighbours.size() || neighbours[k].image != image))
                to.push_back(Run::mark_of(image));
        }
    }
};

} // namespace detail

/// The neighbours among points that stay where they are, nearer than `support`, in the order in which a loop over them
/// computes the fewest packs: that of the cells, with runs alone, or row by row of a lattice with this spacing, with
/// stencils. The order does not depend on the one that is given. All lengths in m.
template <int width, int dim, class Real>
FixedLists find_fixed_lists(const Points<dim, Real>& points, double support, double spacing,
                            const Periodic<dim>& periodic, int threads) {
    FixedLists lists;
    if (points.n == 0)
        return lists;
    const std::vector<std::uint32_t> rows = detail::order_in_rows(points, spacing, threads);
    const detail::PointsInOrder<dim, Real> in_rows(points, rows);
    Grid<dim> grid;
    grid.fit(bounds_of(points, threads), support, periodic, points.n);
    CellTable cells;
    std::vector<std::uint32_t> to_cell(rows.size()), from_cell(rows.size()); // of the places in rows, and back
    std::iota(from_cell.begin(), from_cell.end(), 0U);
    if (!cells.sort(grid, in_rows.points(), threads))
        from_cell = cells.order();
    for (std::size_t k = 0; k < to_cell.size(); ++k)
        to_cell[from_cell[k]] = static_cast<std::uint32_t>(k);
    const detail::PointsInOrder<dim, Real> in_cells(in_rows.points(), from_cell);
    find_runs<width>(lists.runs, in_cells.points(), in_cells.points(), grid, cells, support, threads);
    if constexpr (width > 1) {
        std::size_t in_runs = 0;
        for (int i = 0; i < points.n; ++i)
            in_runs += static_cast<std::size_t>(lists.runs[i].end() - lists.runs[i].begin());
        RunList runs;
        const std::size_t computed =
            detail::ListsInRows<width, dim, Real>(in_cells.points(), lists.runs, to_cell, grid, support)
                .find(runs, lists.stencils, threads);
        if (computed < in_runs) {
            lists.runs = std::move(runs);
            lists.order = rows;
            return lists;
        }
    }
    lists.stencils.clear_all((points.n + width - 1) / width);
    lists.order.resize(rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k)
        lists.order[k] = rows[from_cell[k]];
    return lists;
}

} // namespace imbibe::search
