// The body that particles form, as a shape: to pack a deformed body anew.
#pragma once

#include <imbibe/geometry/image.hpp>

namespace imbibe {

/// The body of particles in a periodic cell, as an image with voxels of about half a spacing: the grey value is the sum
/// of (1 - r^2)^3, r the distance over two spacings, over all particles, and its threshold such that the body has the
/// particles' volume.
///
/// Details finer than two spacings are lost: edges are rounded, slits narrower than two spacings closed.
/// @param points of the particles, m; those outside are taken into the cell
/// @param cell the periodic cell, m
/// @param spacing of the particles, m; each stands for spacing^3
/// @throws Error for no particles, points that are not finite, a cell narrower than 4 spacings, and particles that fill
/// none or all of the cell
[[nodiscard]] inline ImageBody body_of_particles(const std::vector<Point<3>>& points, const Box<3>& cell,
                                                 double spacing) {
    constexpr const char* who = "body_of_particles";
    detail::require_positive(who, "spacing", spacing, "Give the distance between particles in metres.");
    require(cell.bounded(), who, ": the cell must be bounded. Give two corners.");
    require(cell.size().minCoeff() >= 4 * spacing, who, ": the cell is ", cell.size().minCoeff() / spacing,
            " spacings long; it must be at least 4.");
    const double share = static_cast<double>(points.size()) * std::pow(spacing, 3) / cell.volume();
    require(share > 0 && share < 1, who, ": ", points.size(), " particles of ", spacing, " m take ", share,
            " of the cell; it must be between 0 and 1.");
    GreyImage image;
    Point<3> side;
    for (int k = 0; k < 3; ++k) {
        const auto axis = static_cast<std::size_t>(k);
        image.size[axis] = static_cast<int>(std::ceil(2 * cell.size()[k] / spacing - 1e-6));
        side[k] = cell.size()[k] / image.size[axis];
    }
    image.values.assign(image.index(0, 0, image.size[2]), 0.0f);
    const double reach = 2 * spacing;
    for (const Point<3>& x : points) {
        require(x.allFinite(), who, ": a particle is at ", point_text<3>(x), " m; places must be finite.");
        const Point<3> at = (x - cell.lower()).cwiseQuotient(side) - Point<3>::Constant(0.5); // in voxels' centres
        std::array<int, 3> first, last;
        for (int k = 0; k < 3; ++k) {
            first[static_cast<std::size_t>(k)] = static_cast<int>(std::ceil(at[k] - reach / side[k]));
            last[static_cast<std::size_t>(k)] = static_cast<int>(std::floor(at[k] + reach / side[k]));
        }
        const auto within = [](int i, int n) { return (i % n + n) % n; };
        for (int z = first[2]; z <= last[2]; ++z)
            for (int y = first[1]; y <= last[1]; ++y)
                for (int i = first[0]; i <= last[0]; ++i) {
                    const Point<3> offset = (Point<3>(i, y, z) - at).cwiseProduct(side) / reach;
                    const double rest = 1 - offset.squaredNorm();
                    if (rest > 0)
                        image.values[image.index(within(i, image.size[0]), within(y, image.size[1]),
                                                 within(z, image.size[2]))] += static_cast<float>(rest * rest * rest);
                }
    }
    std::vector<float> sorted = image.values;
    const auto pores = static_cast<std::ptrdiff_t>((1 - share) * static_cast<double>(sorted.size()));
    std::nth_element(sorted.begin(), sorted.begin() + pores, sorted.end());
    const double threshold = std::max(static_cast<double>(sorted[static_cast<std::size_t>(pores)]), 1e-6);
    return {std::move(image),
            {.sides = side,
             .threshold = threshold,
             .solid = SolidIs::above,
             .beyond = Beyond::repeated,
             .lower = cell.lower()}};
}

} // namespace imbibe
