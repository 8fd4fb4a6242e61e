// Squared distances from every cell of a grid to the nearest of some cells, in time proportional to the number of
// cells.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace imbibe::detail {

/// Replaces f[i] by min_j (f[j] + (i - j)^2 step^2) along one line: the lower envelope of parabolas, one pass each way
/// (Felzenszwalb and Huttenlocher 2012). Applied along every axis in turn it gives squared distances.
inline void spread_distance(std::vector<double>& line, double step, std::vector<double>& values,
                            std::vector<double>& starts, std::vector<std::size_t>& roots) {
    const std::size_t n = line.size();
    values.resize(n);
    for (std::size_t i = 0; i < n; ++i)
        values[i] = line[i] / (step * step);
    starts.assign(n + 1, 0.0);
    roots.assign(n, 0);
    const auto meet = [&](std::size_t p, std::size_t q) { // where the parabola of q gets below that of p < q
        const double a = static_cast<double>(p);
        const double b = static_cast<double>(q);
        return ((values[q] - values[p]) / (b - a) + a + b) / 2;
    };
    std::size_t top = 0;
    starts[0] = -1e30;
    for (std::size_t q = 1; q < n; ++q) {
        double start = meet(roots[top], q);
        while (start <= starts[top])
            start = meet(roots[--top], q);
        roots[++top] = q;
        starts[top] = start;
    }
    std::size_t piece = 0;
    for (std::size_t i = 0; i < n; ++i) {
        while (piece < top && starts[piece + 1] < static_cast<double>(i))
            ++piece;
        const double offset = static_cast<double>(i) - static_cast<double>(roots[piece]);
        line[i] = (values[roots[piece]] + offset * offset) * (step * step);
    }
}

/// The same along every axis of a grid, x fastest: `distance` holds 0 in the target cells and a number above all
/// squared distances in the others, and receives the squared distances. `step`: distance between cells.
template <int dim>
void spread_distances(std::vector<double>& distance,
                      const std::array<std::size_t, static_cast<std::size_t>(dim)>& cells,
                      const std::array<double, static_cast<std::size_t>(dim)>& step) {
    std::vector<double> line, values, starts;
    std::vector<std::size_t> roots;
    std::size_t stride = 1;
    for (std::size_t k = 0; k < dim; stride *= cells[k++]) {
        line.resize(cells[k]);
        for (std::size_t id = 0; id < distance.size(); ++id) {
            if (id / stride % cells[k] != 0)
                continue;
            for (std::size_t i = 0; i < cells[k]; ++i)
                line[i] = distance[id + i * stride];
            spread_distance(line, step[k], values, starts, roots);
            for (std::size_t i = 0; i < cells[k]; ++i)
                distance[id + i * stride] = line[i];
        }
    }
}

} // namespace imbibe::detail
