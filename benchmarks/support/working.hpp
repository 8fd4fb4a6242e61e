// What a step of a scene has work for.
#pragma once

#include <algorithm>
#include <type_traits>
#include <vector>

namespace imbibe::bench {

/// How many particles of a phase a step has work for: all that move, and of a wall those that have others within reach.
template <class Phase, class Engine>
double working(const Engine& engine, int particles) {
    if constexpr (Phase::moves)
        return particles;
    std::vector<char> works(static_cast<std::size_t>(particles));
    engine.for_each_link([&]<class Between>(Between, const auto& link) {
        if constexpr (std::is_same_v<typename Between::A, Phase>)
            for (int i = 0; i < particles; ++i)
                if (const auto runs = link.runs[i]; runs.begin() != runs.end())
                    works[static_cast<std::size_t>(i)] = 1;
    });
    return static_cast<double>(std::count(works.begin(), works.end(), 1));
}

/// The mean number of neighbours in an engine's first list of neighbours: those of its first phase among its own.
double neighbours_in(const auto& engine) {
    double mean = 0;
    for (const auto& link : engine.links)
        mean = mean > 0 ? mean : engine.mean_neighbours(link);
    return mean;
}

} // namespace imbibe::bench
