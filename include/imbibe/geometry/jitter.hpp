// Moves the points of a lattice a little at random, to break its order.
#pragma once

#include <imbibe/geometry/sampling.hpp>

#include <utility>
#include <vector>

namespace imbibe {

/// The points with every coordinate moved by a random amount between -amplitude and +amplitude (m), evenly
/// distributed. The same points, amplitude and seed give the same result everywhere. A tenth of the spacing breaks a
/// lattice's symmetry; from half a spacing on points may meet.
///
/// Throws Error unless the amplitude is finite and >= 0 m.
template <int dim>
[[nodiscard]] std::vector<Point<dim>> jitter(std::vector<Point<dim>> points, double amplitude, std::uint64_t seed) {
    require(std::isfinite(amplitude) && amplitude >= 0, "jitter: amplitude = ", amplitude,
            " m must be finite and >= 0 m. A tenth of the particle spacing is usual.");
    for (std::size_t i = 0; i < points.size(); ++i)
        for (int axis = 0; axis < dim; ++axis)
            points[i][axis] += amplitude * (2 * random_number(seed, i, static_cast<std::uint64_t>(axis)) - 1);
    return points;
}

} // namespace imbibe
