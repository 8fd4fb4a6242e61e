// The points that the benchmarks work on: a cube of a slightly disordered lattice, in any order wanted.
#pragma once

#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/search/neighbours.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace imbibe::bench {

/// The spacing of all benchmarks, m.
inline constexpr double spacing = 1e-2;

/// About `particles` points of a cube that is a lattice but for a tenth of the spacing.
inline std::vector<Point<3>> cube(int particles) {
    const double side = std::round(std::cbrt(static_cast<double>(particles))) * spacing;
    return jitter(fill(Box<3>({0, 0, 0}, {side, side, side}), spacing), 0.1 * spacing, 1);
}

/// In which order the points lie in memory.
enum class Order {
    sorted,  ///< by cell
    moved,   ///< by cell, but since then everyone has moved by up to a fiftieth of the spacing, as in one step of a run
    shuffled ///< at random
};
inline const char* order_name(Order order) {
    return order == Order::sorted ? "sorted" : order == Order::moved ? "moved" : "shuffled";
}

/// A cube of points as the search wants them, with its grid. As many numbers more than `count` as a pack may read.
template <class Real>
class Cloud {
public:
    std::array<std::vector<Real>, 3> x;
    int count;
    double support;
    search::Grid<3> grid;
    search::CellTable table;

    Cloud(int particles, double support_radius, Order order) : support(support_radius) {
        auto points = cube(particles);
        count = static_cast<int>(points.size());
        if (order == Order::shuffled)
            shuffle(points);
        take(points);
        if (order == Order::shuffled)
            return;
        sort();
        if (order == Order::moved) {
            points.clear();
            for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
                points.push_back(Point<3>(x[0][i], x[1][i], x[2][i]));
            take(jitter(points, 0.02 * spacing, 2));
        }
    }
    search::Points<3, Real> points() const { return {{x[0].data(), x[1].data(), x[2].data()}, count}; }
    /// Fits the grid and finds the order by cells. Are the points in it already?
    bool find_order() {
        grid.fit(search::bounds_of(points(), 1), support, {}, count);
        return table.sort(grid, points(), 1);
    }
    /// Brings one coordinate into the order found.
    void reorder(const std::vector<Real>& from, std::vector<Real>& to) const {
        const auto& order = table.order();
        for (std::size_t i = 0; i < order.size(); ++i)
            to[i] = from[order[i]];
    }
    void sort() {
        if (find_order())
            return;
        for (auto& coordinate : x) {
            std::vector<Real> moved = coordinate;
            reorder(coordinate, moved);
            coordinate.swap(moved);
        }
    }

private:
    void take(const std::vector<Point<3>>& points) {
        for (std::size_t d = 0; d < 3; ++d) {
            x[d].assign(points.size() + 64, Real(0));
            for (std::size_t i = 0; i < points.size(); ++i)
                x[d][i] = static_cast<Real>(points[i][static_cast<int>(d)]);
        }
    }
    // Fisher and Yates, with random numbers that are the same everywhere.
    static void shuffle(std::vector<Point<3>>& points) {
        for (std::size_t i = points.size(); i > 1; --i) {
            const double u = random_number(3, i, 0);
            std::swap(points[i - 1], points[std::min(static_cast<std::size_t>(u * static_cast<double>(i)), i - 1)]);
        }
    }
};

/// The mean number of runs of a particle.
inline double runs_per_particle(const search::RunList& list) {
    long long runs = 0;
    for (int i = 0; i < list.size(); ++i)
        runs += list[i].end() - list[i].begin();
    return static_cast<double>(runs) / list.size();
}

} // namespace imbibe::bench
