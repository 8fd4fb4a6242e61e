// Into how many pieces a phase has come: fragments.
#pragma once

#include <imbibe/core/fields.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace imbibe::bench {

/// What a phase has come to.
struct Pieces {
    std::vector<int> sizes; // of the pieces, in particles
    double closest;         // of two particles, m
};
/// Particles hang together where they are at most `reach` apart.
inline Pieces pieces(const auto& view, double reach) {
    const auto x = view[position];
    const int n = view.size();
    std::vector<int> order(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i)
        order[static_cast<std::size_t>(i)] = i;
    std::sort(order.begin(), order.end(), [&](int i, int j) { return x(i, 0) < x(j, 0); });
    std::vector<std::size_t> parent(order.size());
    for (std::size_t k = 0; k < parent.size(); ++k)
        parent[k] = k;
    const auto find = [&](std::size_t k) {
        while (parent[k] != k)
            k = parent[k] = parent[parent[k]];
        return k;
    };
    double closest = reach;
    for (std::size_t k = 0; k < order.size(); ++k)
        for (std::size_t l = k + 1; l < order.size() && static_cast<double>(x(order[l], 0) - x(order[k], 0)) <= reach;
             ++l)
            if (const double apart = static_cast<double>((x.row(order[l]) - x.row(order[k])).norm()); apart <= reach) {
                parent[find(l)] = find(k);
                closest = std::min(closest, apart);
            }
    std::vector<int> size(order.size(), 0);
    for (std::size_t k = 0; k < order.size(); ++k)
        ++size[find(k)];
    size.erase(std::remove(size.begin(), size.end(), 0), size.end());
    std::sort(size.begin(), size.end());
    return {size, closest};
}

} // namespace imbibe::bench
