// A grid of cells over all particles: cells are as wide as the support radius across, and an eighth of it along x, so
// that the neighbours of a particle in one row of cells are one contiguous stretch of the sorted order. Where that
// would be far too many cells, the grid is folded: it repeats periodically, so places far apart share a cell.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/pack_functions.hpp>
#include <imbibe/core/parallel.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace imbibe::search {

/// The number of values behind the last particle's that may be read and must exist; their values do not matter.
inline constexpr std::size_t read_beyond = 64;

/// The coordinates of n particles: x[d][i], d < dim, with `read_beyond` numbers behind them.
template <int dim, class Real>
struct Points {
    std::array<const Real*, static_cast<std::size_t>(dim)> x{}; ///< x[d][i], m
    int n = 0;                                                  ///< how many points
};

/// Periodic sides of the domain: those with `length[d]` > 0; particles lie in [lower, lower + length).
template <int dim>
struct Periodic {
    /// Where a period begins and how long it is, m.
    std::array<double, static_cast<std::size_t>(dim)> lower{}, length{};
};

/// x moved by whole periods into [lower, lower + length), m. NaN and infinities stay non-finite.
template <class Real>
IMBIBE_PER_BUILD Real into_period(Real x, Real lower, Real length) {
    if (x >= lower && x < lower + length)
        return x;
    x -= length * std::floor((x - lower) / length);
    return x < lower || x >= lower + length ? lower : x; // rounding may leave it on the far side
}

/// The smallest box around a set of points.
template <int dim>
struct Bounds {
    /// The corners of the box, m.
    std::array<double, static_cast<std::size_t>(dim)> lower, upper;
    int not_finite = -1; ///< the index of a point with a coordinate that is not a finite number

    Bounds() {
        lower.fill(1e300);
        upper.fill(-1e300);
    }
    /// Does it hold no point?
    bool empty() const { return !(lower[0] <= upper[0]); }
    /// Makes it hold the other box as well.
    void include(const Bounds& b) {
        for (std::size_t d = 0; d < dim; ++d) {
            lower[d] = std::min(lower[d], b.lower[d]);
            upper[d] = std::max(upper[d], b.upper[d]);
        }
        if (not_finite < 0)
            not_finite = b.not_finite;
    }
    /// Are the boxes further apart than `reach`, in the directions that are not periodic?
    bool far_from(const Bounds& b, double reach, const Periodic<dim>& periodic = {}) const {
        if (empty() || b.empty())
            return true;
        for (std::size_t d = 0; d < dim; ++d)
            if (periodic.length[d] == 0 && (lower[d] > b.upper[d] + reach || b.lower[d] > upper[d] + reach))
                return true;
        return false;
    }
};

/// The bounds of a set of points.
template <int dim, class Real>
IMBIBE_PER_BUILD Bounds<dim> bounds_of(const Points<dim, Real>& points, int threads) {
    return parallel_reduce(
        points.n, threads, Bounds<dim>{},
        [&](int begin, int end) {
            using T = Pack<Real, native_width<Real>>;
            const T most(1e30); // so that NaN does not compare as less
            Bounds<dim> b;
            for (std::size_t d = 0; d < dim; ++d) {
                const Real* x = points.x[d];
                T low(x[begin]), high = low;
                std::uint32_t finite = less_bits(abs(low), most);
                const auto include = [&](T some) {
                    low = min(some, low);
                    high = max(some, high);
                    finite &= less_bits(abs(some), most);
                };
                int i = begin;
                for (; i + T::size <= end; i += T::size)
                    include(T::load(x + i));
                for (; i < end; ++i)
                    include(T(x[i]));
                if (finite != less_bits(T(0), most))
                    for (i = begin; b.not_finite < 0; ++i)
                        b.not_finite = abs(x[i]) < Real(1e30) ? -1 : i;
                for (int k = 0; k < T::size; ++k) {
                    b.lower[d] = std::min(b.lower[d], static_cast<double>(low[k]));
                    b.upper[d] = std::max(b.upper[d], static_cast<double>(high[k]));
                }
            }
            return b;
        },
        [](Bounds<dim> a, const Bounds<dim>& b) {
            a.include(b);
            return a;
        });
}

/// The cells, shared by all point sets of a scene.
template <int dim>
class IMBIBE_PER_BUILD Grid {
public:
    /// Covers `bounds` with cells for neighbours within `support`. Memory is bounded for any extent: where there would
    /// be more than about eight cells a particle, as when a few drops have flown far away, the longest directions are
    /// folded. Distant particles that share a folded cell are rejected by their distance, like all others in it, so
    /// folding is slower only where many do. Periodic directions are not folded: where a period is too long, its cells
    /// are made larger.
    void fit(const Bounds<dim>& bounds, double support, const Periodic<dim>& periodic, long long particles) {
        periods = periodic;
        const double most = std::min(8.0 * static_cast<double>(particles) + 4096, 4e9); // cells are numbered in 32 bits
        std::array<double, static_cast<std::size_t>(dim)> low{}, extent{}, width{};
        for (std::size_t d = 0; d < dim; ++d) {
            const bool wraps = periodic.length[d] > 0;
            width[d] = d == 0 ? support / 8 : support;
            low[d] = wraps ? periodic.lower[d] : begin(bounds.lower[d], width[d]);
            extent[d] = wraps ? periodic.length[d] : bounds.upper[d] - low[d];
        }
        const auto length = [&](std::size_t d) { // in supports, behind whether to fold it before a period's cells grow
            const double supports = extent[d] / width[d] * (d == 0 ? 0.125 : 1);
            return std::pair(periodic.length[d] == 0 && supports > 16, supports);
        };
        folded_.fill(false);
        for (;;) {
            double cells = 1;
            for (std::size_t d = 0; d < dim; ++d)
                cells *= std::floor(extent[d] / width[d]) + 1;
            if (cells <= most)
                break;
            std::size_t longest = 0; // of those above seven supports, as the cells are more than 4096
            for (std::size_t d = 1; d < dim; ++d)
                if (length(d) > length(longest))
                    longest = d;
            if (periodic.length[longest] > 0) {
                width[longest] *= 2;
            } else { // to at least four supports, a power of two: the same for many steps of a flying drop
                const double n = std::ceil(std::min(extent[longest] / width[longest], farthest));
                extent[longest] = width[longest] * (std::bit_ceil(static_cast<std::uint32_t>(n)) / 2);
                folded_[longest] = true;
            }
        }
        for (std::size_t d = 0; d < dim; ++d) {
            if (periodic.length[d] > 0) {
                n_[d] = std::max(1, static_cast<int>(extent[d] / width[d]));
                width[d] = extent[d] / n_[d];
            } else if (folded_[d]) {
                n_[d] = static_cast<int>(extent[d] / width[d]);
                // Not from the lowest particle, from which the others may be very far.
                low[d] = begin(std::clamp(0.0, bounds.lower[d], bounds.upper[d]), n_[d] * width[d]);
            } else {
                n_[d] = static_cast<int>(std::floor(extent[d] / width[d])) + 1;
            }
            wraps_[d] = periodic.length[d] > 0 || folded_[d];
            lower_[d] = low[d];
            width_[d] = width[d];
            inverse_[d] = 1 / width[d];
        }
    }
    /// Number of cells along d.
    int n(int d) const { return n_[static_cast<std::size_t>(d)]; }
    /// Where cell 0 begins along d, m.
    double lower(int d) const { return lower_[static_cast<std::size_t>(d)]; }
    /// The width of a cell along d, m.
    double width(int d) const { return width_[static_cast<std::size_t>(d)]; }
    /// Is the first cell along d next to the last one? It is in a periodic direction, and in a folded one, which acts
    /// like a period of length zero.
    bool wraps(int d) const { return wraps_[static_cast<std::size_t>(d)]; }
    /// The period along d, m; 0 where there is none.
    double length(int d) const { return periods.length[static_cast<std::size_t>(d)]; }
    /// The number of cells.
    std::size_t cells() const {
        std::size_t product = 1;
        for (int k : n_)
            product *= static_cast<std::size_t>(k);
        return product;
    }
    /// Is the grid folded along d, so that places n(d) cells apart share a cell?
    bool is_folded(int d) const { return folded_[static_cast<std::size_t>(d)]; }
    /// The place `at` along d, in cells from the beginning of the folded grid: from 0 to n(d). A place so far away that
    /// few digits are left for its position in a cell is moved nearer first. This never increases distances, so
    /// neighbours stay neighbours.
    [[gnu::cold]] double fold(int d, double at) const {
        if (!is_folded(d))
            return at;
        at = std::clamp(at, -farthest, farthest);
        return at - n(d) * std::floor(at / n(d));
    }
    /// The cell of coordinate x along d; for x outside the grid, beyond its first or last one.
    int cell(int d, double x) const {
        return static_cast<int>(
            std::floor(fold(d, (x - lower_[static_cast<std::size_t>(d)]) * inverse_[static_cast<std::size_t>(d)])));
    }
    /// The numbers of the cells of points [begin, end), to[i] for point i: rows along x, one after the other. A point
    /// outside the grid gets the cell at its rim.
    template <class Real>
    void find_cells(const Points<dim, Real>& points, int begin, int end, std::uint32_t* to) const {
        const auto n = n_; // copies, which writing `to` cannot change, so that the loop is computed in packs
        const auto lower = lower_, inverse = inverse_;
        const auto x = points.x;
        const auto number = [&](const auto& folded) {
            // Truncated, not rounded down: below the grid both give cell 0, and processors truncate in packs.
            const auto along = [&](std::size_t d, int i) {
                const int c = static_cast<int>(folded(d, (static_cast<double>(x[d][i]) - lower[d]) * inverse[d]));
                return static_cast<std::uint32_t>(c < 0 ? 0 : c < n[d] ? c : n[d] - 1);
            };
            for (int i = begin; i < end; ++i) {
                std::uint32_t row = along(1, i);
                if constexpr (dim == 3)
                    row += along(2, i) * static_cast<std::uint32_t>(n[1]);
                to[i] = row * static_cast<std::uint32_t>(n[0]) + along(0, i);
            }
        };
        if (std::find(folded_.begin(), folded_.end(), true) != folded_.end())
            number([&](std::size_t d, double at) { return fold(static_cast<int>(d), at); });
        else
            number([](std::size_t, double at) { return at; });
    }

private:
    // Cells are counted from a multiple of their width, so that sorted particles stay sorted when others move; from the
    // first particle if a coordinate has no digits left for that.
    static double begin(double lower, double width) {
        return std::abs(lower) < 1e15 * width ? std::floor(lower / width) * width : lower;
    }
    static constexpr double farthest = 0x1p30; ///< cells
    Periodic<dim> periods;
    std::array<bool, static_cast<std::size_t>(dim)> folded_{}, wraps_{};
    std::array<int, static_cast<std::size_t>(dim)> n_{};
    std::array<double, static_cast<std::size_t>(dim)> lower_{}, width_{}, inverse_{};
};

/// The range of each cell in the sorted order of one point set.
class IMBIBE_PER_BUILD CellTable {
public:
    /// Counting sort by cell, stable. Afterwards `order()[k]` is the present index of the particle that belongs at k.
    /// Returns whether the points are sorted already. Threads share the points in blocks, then the cells in stretches;
    /// the result does not depend on their number.
    template <int dim, class Real>
    bool sort(const Grid<dim>& grid, const Points<dim, Real>& points, int threads) {
        const auto n = static_cast<std::size_t>(points.n);
        const std::size_t cells = grid.cells(), parts = threads > 2 ? 4 * static_cast<std::size_t>(threads) : 1;
        // Two threads would win little: they read all points once more, in an order that is scattered at first.
        int shift = 0; // a stretch is 2^shift cells
        while ((cells - 1) >> shift >= parts)
            ++shift;
        const auto for_each_part = [&](const auto& f) {
            parallel_for(static_cast<int>(parts), threads, [&](int p) { f(static_cast<std::size_t>(p)); });
        };
        const auto block = [&](std::size_t p) { return n * p / parts; };
        keys.resize(n);
        places.assign(parts * parts + 1, 0); // of each stretch, how many points each block has; then where they go
        places[0] = static_cast<std::uint32_t>(parts > 1 ? 0 : n);
        for_each_part([&](std::size_t p) {
            grid.find_cells(points, static_cast<int>(block(p)), static_cast<int>(block(p + 1)), keys.data());
            for (std::size_t i = block(p); i < block(p + 1) && parts > 1; ++i)
                ++places[(keys[i] >> shift) * parts + p];
        });
        const bool sorted = parallel_reduce(
            points.n, threads, true,
            [&](int begin, int end) {
                return std::is_sorted(keys.begin() + begin, keys.begin() + (end < points.n ? end + 1 : end));
            },
            [](bool one, bool other) { return one && other; });
        std::exclusive_scan(places.begin(), places.end(), places.begin(), std::uint32_t{0});
        std::vector<std::uint32_t> begins(parts + 1); // of the stretches, among the sorted points
        for (std::size_t r = 0; r <= parts; ++r)
            begins[r] = places[r * parts];
        const bool dealt = parts > 1 && !sorted; // do stretches have lists of their points?
        if (dealt) {
            by_stretch.resize(n);
            for_each_part([&](std::size_t p) {
                for (std::size_t i = block(p); i < block(p + 1); ++i)
                    by_stretch[places[(keys[i] >> shift) * parts + p]++] = static_cast<std::uint32_t>(i);
            });
        }
        start_.resize(cells + 1);
        if (!sorted) {
            next.resize(cells);
            order_.resize(n);
        }
        for_each_part([&](std::size_t r) {
            const auto for_each_point = [&](const auto& f) {
                for (std::uint32_t k = begins[r]; k < begins[r + 1]; ++k)
                    f(dealt ? by_stretch[k] : k);
            };
            const std::size_t first = std::min(r << shift, cells), last = std::min((r + 1) << shift, cells);
            std::fill(start_.begin() + static_cast<std::ptrdiff_t>(first),
                      start_.begin() + static_cast<std::ptrdiff_t>(last), 0U);
            for_each_point([&](std::uint32_t i) { ++start_[keys[i]]; });
            std::uint32_t before = begins[r];
            for (std::size_t c = first; c < last; ++c)
                before += std::exchange(start_[c], before);
            if (!sorted) {
                std::copy(start_.begin() + static_cast<std::ptrdiff_t>(first),
                          start_.begin() + static_cast<std::ptrdiff_t>(last),
                          next.begin() + static_cast<std::ptrdiff_t>(first));
                for_each_point([&](std::uint32_t i) { order_[next[keys[i]]++] = i; });
            }
        });
        start_[cells] = static_cast<std::uint32_t>(n);
        return sorted;
    }
    /// The sorted order, as of the last `sort` that returned false.
    const std::vector<std::uint32_t>& order() const { return order_; }
    /// The first particle of a cell; of the cell after the last one, the number of particles.
    std::uint32_t start(std::size_t cell) const { return start_[cell]; }

private:
    std::vector<std::uint32_t> keys, order_, start_, next, places, by_stretch;
};

} // namespace imbibe::search
