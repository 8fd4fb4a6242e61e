// The code of outline.hpp: sorts places into cells and numbers the bodies they make.
#pragma once

#include <imbibe/solver/outline.hpp>

namespace imbibe::detail {

IMBIBE_CODE OutlineBox box_around(const OutlineColumns& columns) {
    OutlineBox box;
    for (int i = 0; i < columns.n; ++i)
        box.include(columns.at(i));
    return box;
}

IMBIBE_CODE PlacesByCell::PlacesByCell(const std::vector<Coordinates>& places, double reach,
                                       const OutlineOfScene& scene)
    : reach_(reach), period_(scene.period), lower_(scene.lower) {
    OutlineBox box;
    for (const Coordinates& x : places)
        box.include(x);
    for (std::size_t d = 0; d < 3; ++d)
        if (period_[d] > 0)
            reach_ = std::min(reach_, period_[d]);
        else
            lower_[d] = box.lower[d];
    for (std::size_t d = 0; d < 3; ++d) { // whole cells in a period
        cells_[d] = period_[d] > 0 ? std::clamp(static_cast<long long>(period_[d] / reach_), 1ll, most) : 0;
        width_[d] = cells_[d] > 0 ? period_[d] / static_cast<double>(cells_[d]) : reach_;
    }
    std::vector<std::pair<std::uint64_t, int>> order;
    order.reserve(places.size());
    for (const Coordinates& x : places)
        order.emplace_back(key_of(cell_of(wrapped(x))), static_cast<int>(order.size()));
    std::sort(order.begin(), order.end());
    for (const auto& [key, i] : order) {
        keys_.push_back(key);
        numbers_.push_back(i);
        places_.push_back(wrapped(places[static_cast<std::size_t>(i)]));
    }
}

IMBIBE_CODE void PlacesByCell::Lookup::find_ranges() {
    ranges_.clear();
    Cell from = own_, to = own_;
    for (std::size_t d = 0; d < 3; ++d) {
        const bool few = cells_.cells_[d] > 0 && cells_.cells_[d] < 3; // each once
        from[d] = few ? 0 : own_[d] - 1;
        to[d] = few ? cells_.cells_[d] - 1 : own_[d] + 1;
    }
    Cell cell;
    for (cell[2] = from[2]; cell[2] <= to[2]; ++cell[2])
        for (cell[1] = from[1]; cell[1] <= to[1]; ++cell[1])
            for (cell[0] = from[0]; cell[0] <= to[0]; ++cell[0])
                add(cells_.repeated(cell));
}

IMBIBE_CODE std::vector<int> bodies_of(const OutlineColumns& columns, double reach, const OutlineOfScene& scene) {
    std::vector<Coordinates> places;
    for (int i = 0; i < columns.n; ++i)
        places.push_back(columns.at(i));
    const PlacesByCell cells(places, reach, scene);
    PlacesByCell::Lookup nearby(cells);
    std::vector<int> number(places.size(), -1), ahead;
    int bodies = 0;
    const auto join = [&](int j, const Coordinates&, double) {
        if (int& of_j = number[static_cast<std::size_t>(j)]; of_j < 0) {
            of_j = bodies;
            ahead.push_back(j);
        }
    };
    for (int first = 0; first < columns.n; ++first) {
        if (number[static_cast<std::size_t>(first)] >= 0)
            continue;
        join(first, {}, 0);
        while (!ahead.empty()) {
            const int i = ahead.back();
            ahead.pop_back();
            nearby.for_each_near(places[static_cast<std::size_t>(i)], join);
        }
        ++bodies;
    }
    return number;
}

} // namespace imbibe::detail
