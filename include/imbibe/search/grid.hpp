// A grid of cells over all particles: cells as wide as the support radius across, and an eighth of it along x, so
// that the neighbours of a particle in one row of cells are one contiguous stretch of the sorted order.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/parallel.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace imbibe::search {

/// So many numbers behind the last particle's may be read, and must be there; what they are does not matter.
inline constexpr std::size_t read_beyond = 64;

/// The coordinates of n particles: x[d][i], d < dim, with `read_beyond` numbers behind them.
template <int dim, class Real>
struct Points {
    std::array<const Real*, static_cast<std::size_t>(dim)> x{}; ///< x[d][i], m
    int n = 0;                                                  ///< how many points
};

/// Sides of the domain that are periodic: `length[d]` > 0 says so, and particles live in [lower, lower + length).
template <int dim>
struct Periodic {
    /// Where a period begins and how long it is, m.
    std::array<double, static_cast<std::size_t>(dim)> lower{}, length{};
};

/// x moved by whole periods into [lower, lower + length), m.
template <class Real>
Real into_period(Real x, Real lower, Real length) {
    if (x >= lower && x < lower + length)
        return x;
    x -= length * std::floor((x - lower) / length);
    return x >= lower && x < lower + length ? x : lower; // rounding may leave it on the far side
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
    /// Is there no point in it?
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
    /// Is there no point of one within `reach` of the other, judged by the boxes in the directions that do not repeat?
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
            Bounds<dim> b;
            for (std::size_t d = 0; d < dim; ++d) {
                Real low = points.x[d][begin], high = low;
                for (int i = begin; i < end; ++i) {
                    const Real x = points.x[d][i];
                    low = x < low ? x : low;
                    high = x > high ? x : high;
                    if (!(std::abs(x) < Real(1e30)))
                        b.not_finite = i;
                }
                b.lower[d] = static_cast<double>(low);
                b.upper[d] = static_cast<double>(high);
            }
            return b;
        },
        [](Bounds<dim> a, const Bounds<dim>& b) {
            a.include(b);
            return a;
        });
}

/// The cells, shared by all sets of points of a scene.
template <int dim>
class Grid {
public:
    /// Covers `bounds` with cells for neighbours within `support`. Memory is bounded for any extent: where the
    /// cells would be more than about eight a particle, they are made larger (slower, never wrong).
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
        for (;;) {
            double cells = 1;
            for (std::size_t d = 0; d < dim; ++d)
                cells *= std::floor(extent[d] / width[d]) + 1;
            if (cells <= most)
                break;
            std::size_t longest = 0; // measured in supports
            for (std::size_t d = 1; d < dim; ++d)
                if (extent[d] / width[d] * (d == 0 ? 0.125 : 1) >
                    extent[longest] / width[longest] * (longest == 0 ? 0.125 : 1))
                    longest = d;
            width[longest] *= 2;
        }
        for (std::size_t d = 0; d < dim; ++d) {
            if (periodic.length[d] > 0) {
                n_[d] = std::max(1, static_cast<int>(extent[d] / width[d]));
                width[d] = extent[d] / n_[d];
            } else { // the width may be another now
                low[d] = begin(bounds.lower[d], width[d]);
                n_[d] = static_cast<int>(std::floor((bounds.upper[d] - low[d]) / width[d])) + 1;
            }
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
    /// Is d a periodic direction?
    bool wraps(int d) const { return periods.length[static_cast<std::size_t>(d)] > 0; }
    /// The period along d, m; 0 where there is none.
    double length(int d) const { return periods.length[static_cast<std::size_t>(d)]; }
    /// The number of cells.
    std::size_t cells() const {
        std::size_t product = 1;
        for (int k : n_)
            product *= static_cast<std::size_t>(k);
        return product;
    }
    /// The cell of coordinate x along d, before clamping or wrapping.
    int cell(int d, double x) const {
        return static_cast<int>(
            std::floor((x - lower_[static_cast<std::size_t>(d)]) * inverse_[static_cast<std::size_t>(d)]));
    }
    /// The cell of coordinate x along d, inside the grid.
    int inside(int d, double x) const { return std::clamp(cell(d, x), 0, n(d) - 1); }
    /// The number of the cell of point i: rows along x, one after the other.
    template <class Real>
    std::uint32_t key(const Points<dim, Real>& points, int i) const {
        std::uint32_t k = 0;
        for (int d = dim - 1; d >= 0; --d)
            k = k * static_cast<std::uint32_t>(n(d)) +
                static_cast<std::uint32_t>(inside(d, static_cast<double>(points.x[static_cast<std::size_t>(d)][i])));
        return k;
    }

private:
    // Cells are counted from a multiple of their width, so that sorted particles stay sorted when others move. Where a
    // coordinate has no digits left for that, from the first particle.
    static double begin(double lower, double width) {
        return std::abs(lower) < 1e15 * width ? std::floor(lower / width) * width : lower;
    }
    Periodic<dim> periods;
    std::array<int, static_cast<std::size_t>(dim)> n_{};
    std::array<double, static_cast<std::size_t>(dim)> lower_{}, width_{}, inverse_{};
};

/// Where the particles of each cell stand in the sorted order of one set of points.
class IMBIBE_PER_BUILD CellTable {
public:
    /// Counting sort by cell, stable. Afterwards `order()[k]` is the present index of the particle that belongs at k.
    /// Returns whether the points are in that order already.
    template <int dim, class Real>
    bool sort(const Grid<dim>& grid, const Points<dim, Real>& points, int threads) {
        const std::size_t cells = grid.cells();
        keys.resize(static_cast<std::size_t>(points.n));
        parallel_blocks(points.n, 4096, threads, [&](int begin, int end) {
            for (int i = begin; i < end; ++i)
                keys[static_cast<std::size_t>(i)] = grid.key(points, i);
        });
        start_.assign(cells + 1, 0);
        for (std::uint32_t k : keys)
            ++start_[k + 1];
        for (std::size_t c = 0; c < cells; ++c)
            start_[c + 1] += start_[c];
        if (std::is_sorted(keys.begin(), keys.end()))
            return true;
        order_.resize(static_cast<std::size_t>(points.n));
        next = start_;
        for (std::size_t i = 0; i < keys.size(); ++i)
            order_[next[keys[i]]++] = static_cast<std::uint32_t>(i);
        return false;
    }
    /// The sorted order, as of the last `sort` that returned false.
    const std::vector<std::uint32_t>& order() const { return order_; }
    /// The first particle of a cell; of the cell after the last one, the number of particles.
    std::uint32_t start(std::size_t cell) const { return start_[cell]; }

private:
    std::vector<std::uint32_t> keys, order_, start_, next;
};

} // namespace imbibe::search
