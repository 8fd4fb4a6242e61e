// All pairs, the slow and obvious way: what the neighbour search is compared with.
#pragma once

#include <imbibe/search/neighbours.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <tuple>
#include <vector>

namespace search_test {

using imbibe::search::CellTable;
using imbibe::search::Grid;
using imbibe::search::Periodic;
using imbibe::search::Run;
using imbibe::search::RunList;

/// Points in memory as the search wants them: one array a coordinate, with room for a pack beyond the end.
template <int dim, class Real>
struct Cloud {
    std::array<std::vector<Real>, static_cast<std::size_t>(dim)> x;
    int n = 0;

    void add(const std::array<double, static_cast<std::size_t>(dim)>& at) {
        for (std::size_t d = 0; d < dim; ++d) {
            x[d].resize(static_cast<std::size_t>(n));
            x[d].push_back(static_cast<Real>(at[d]));
        }
        ++n;
    }
    imbibe::search::Points<dim, Real> points() {
        imbibe::search::Points<dim, Real> p;
        p.n = n;
        for (std::size_t d = 0; d < dim; ++d) {
            x[d].resize(static_cast<std::size_t>(n + 64)); // zeros: they must never come out as neighbours
            p.x[d] = x[d].data();
        }
        return p;
    }
    void reorder(const std::vector<std::uint32_t>& order) {
        for (auto& column : x) {
            std::vector<Real> moved(column.size());
            for (std::size_t i = 0; i < order.size(); ++i)
                moved[i] = column[order[i]];
            column = moved;
        }
    }
    double at(int i, int d) const {
        return static_cast<double>(x[static_cast<std::size_t>(d)][static_cast<std::size_t>(i)]);
    }
};

/// Neighbour j seen through the image that is displaced by these periods.
using Neighbour = std::tuple<int, std::array<int, 3>>;

/// One comparison: sources are sorted, runs are found, and every target's neighbours are compared with all pairs.
template <int width, int dim, class Real>
struct Comparison {
    double support;
    Periodic<dim> periodic{};
    int threads = 1;
    int wrong = 0;       ///< targets whose neighbours are not those of brute force
    int twice = 0;       ///< neighbours listed twice
    int unsorted = 0;    ///< 1 if the sources are not sorted after sorting
    long long pairs = 0; ///< neighbours found in all
    int longest = 0;     ///< the count of the longest run

    void run(Cloud<dim, Real>& targets, Cloud<dim, Real>& sources) {
        auto source_points = sources.points();
        auto bounds = imbibe::search::bounds_of(source_points, threads);
        bounds.include(imbibe::search::bounds_of(targets.points(), threads));
        Grid<dim> grid;
        grid.fit(bounds, support, periodic, targets.n + sources.n);
        CellTable table;
        if (!table.sort(grid, source_points, threads)) {
            sources.reorder(table.order());
            source_points = sources.points();
            unsorted += table.sort(grid, source_points, threads) ? 0 : 1;
        }
        RunList list;
        imbibe::search::find_runs<width>(list, targets.points(), source_points, grid, table, support, threads);
        compare(targets, sources, list);
    }
    /// Compares given runs.
    void compare(const Cloud<dim, Real>& targets, const Cloud<dim, Real>& sources, const RunList& list) {
        for (int i = 0; i < targets.n; ++i)
            wrong += agrees(targets, sources, list, i) ? 0 : 1;
    }

private:
    // Pairs whose distance is the support to rounding may be listed or not: their kernel is zero.
    double doubt() const { return sizeof(Real) == 4 ? 1e-4 : 1e-9; }

    double distance(const Cloud<dim, Real>& a, int i, const Cloud<dim, Real>& b, int j,
                    const std::array<int, 3>& step) const {
        double sum = 0;
        for (int d = 0; d < dim; ++d) {
            const auto k = static_cast<std::size_t>(d);
            double here = a.at(i, d);
            if (periodic.length[k] > 0) // images are those seen from inside the box
                here = static_cast<double>(imbibe::search::into_period(static_cast<Real>(here),
                                                                       static_cast<Real>(periodic.lower[k]),
                                                                       static_cast<Real>(periodic.length[k])));
            const double gap = here - step[k] * periodic.length[k] - b.at(j, d);
            sum += gap * gap;
        }
        return std::sqrt(sum);
    }

    bool agrees(const Cloud<dim, Real>& targets, const Cloud<dim, Real>& sources, const RunList& list, int i) {
        std::set<Neighbour> found;
        int before = 0;
        bool whole = true;
        list[i].for_each([&](Run run, int image) {
            whole = whole && (image != 0 || before == 0); // those that are seen through no image come first
            before = image;
            longest = std::max(longest, static_cast<int>(run.count()));
            whole = whole && run.count() <= width && run.first() + run.count() <= static_cast<std::size_t>(sources.n);
            std::array<int, 3> step{};
            for (int d = 0; d < dim; ++d)
                if (const auto k = static_cast<std::size_t>(d); periodic.length[k] > 0) // else it is no other place
                    step[k] = imbibe::search::image_step(image, d);
            for (std::size_t k = 0; k < run.count(); ++k) {
                const int j = static_cast<int>(run.first() + k);
                if (!found.insert({j, step}).second)
                    ++twice;
            }
        });
        if (!whole)
            return false;
        std::set<Neighbour> near;
        for (const auto& [j, step] : found)
            if (distance(targets, i, sources, j, step) < support * (1 - doubt()))
                near.insert({j, step});
        std::set<Neighbour> all;
        std::array<int, 3> reach{};
        for (std::size_t d = 0; d < dim; ++d)
            reach[d] = periodic.length[d] > 0 ? 2 : 0;
        for (int x = -reach[0]; x <= reach[0]; ++x)
            for (int y = -reach[1]; y <= reach[1]; ++y)
                for (int z = -reach[2]; z <= reach[2]; ++z)
                    for (int j = 0; j < sources.n; ++j)
                        if (distance(targets, i, sources, j, {x, y, z}) < support * (1 - doubt()))
                            all.insert({j, {x, y, z}});
        pairs += static_cast<long long>(near.size());
        return near == all;
    }
};

/// Points at random in a box.
template <int dim, class Real>
Cloud<dim, Real> random_cloud(int n, double lower, double upper, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(lower, upper);
    Cloud<dim, Real> cloud;
    for (int i = 0; i < n; ++i) {
        std::array<double, static_cast<std::size_t>(dim)> x;
        for (auto& c : x)
            c = uniform(generator);
        cloud.add(x);
    }
    return cloud;
}

/// A cubic lattice of m points a side, from `origin` on.
template <int dim, class Real>
Cloud<dim, Real> lattice(int m, double spacing, double origin) {
    Cloud<dim, Real> cloud;
    for (int z = 0; z < (dim == 3 ? m : 1); ++z)
        for (int y = 0; y < m; ++y)
            for (int x = 0; x < m; ++x) {
                const int at[] = {x, y, z};
                std::array<double, static_cast<std::size_t>(dim)> p;
                for (std::size_t d = 0; d < dim; ++d)
                    p[d] = origin + spacing * at[d];
                cloud.add(p);
            }
    return cloud;
}

} // namespace search_test
