// Stateless numbers: repeatable random numbers and evenly spread sample points, the same on every machine and with
// every standard library; and measurements with them: volume fractions and levels.
#pragma once

#include <imbibe/geometry/shape.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace imbibe {

/// A random number in [0, 1), a function of its three arguments only: the same seed, index and stream give the same
/// number. Two rounds of the SplitMix64 finaliser (Steele, Lea and Flood 2014).
[[nodiscard]] constexpr double random_number(std::uint64_t seed, std::uint64_t index, std::uint64_t stream = 0) {
    const auto mix = [](std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    };
    constexpr std::uint64_t golden = 0x9e3779b97f4a7c15ULL;
    const std::uint64_t bits = mix(mix(seed + golden * (stream + 1)) + golden * (index + 1));
    return static_cast<double>(bits >> 11) * 0x1p-53; // the upper 53 bits, all that a double holds
}

/// Point number `index` of a sequence that covers the box more evenly than random points do: x_k = frac(i / g^k), g
/// the root of g^(dim+1) = g + 1 (Roberts 2018). Averages over n of them err by about 1/n, not 1/sqrt(n).
template <int dim>
[[nodiscard]] Point<dim> even_point(const Box<dim>& box, std::uint64_t index) {
    constexpr double root = dim == 2 ? 1.32471795724474602596 : 1.22074408460575947536;
    Point<dim> point;
    double step = 1;
    for (int axis = 0; axis < dim; ++axis) {
        step /= root;
        const double turn = 0.5 + step * static_cast<double>(index + 1);
        point[axis] = box.lower()[axis] + (turn - std::floor(turn)) * box.size()[axis];
    }
    return point;
}

/// The share (0 to 1) of the bounded box `box` that the shape fills, from `samples` evenly spread points; with the
/// default the error is below about 0.002. Throws Error if the box is unbounded or samples is 0.
template <AnyShape S>
[[nodiscard]] double volume_fraction(const S& shape, const Box<shape_dimension<S>>& box,
                                     std::uint64_t samples = 1u << 16) {
    require(box.bounded(), "volume_fraction: the box must be bounded. Give two corners.");
    require(samples > 0, "volume_fraction: samples = 0 must be at least 1; some 10000 give 1 % accuracy.");
    std::uint64_t hits = 0;
    for (std::uint64_t i = 0; i < samples; ++i)
        hits += shape.contains(even_point(box, i)) ? 1u : 0u;
    return static_cast<double>(hits) / static_cast<double>(samples);
}

namespace detail {

/// The level below which the share `fraction` (0 to 1) of the values lies. Reorders the values.
inline double level_of(std::vector<double>& values, double fraction) {
    const auto rank = static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size()));
    const auto last = static_cast<std::ptrdiff_t>(values.size()) - 1;
    const auto place = values.begin() + std::clamp<std::ptrdiff_t>(rank, 0, last);
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

} // namespace detail
} // namespace imbibe
