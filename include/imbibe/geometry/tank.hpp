// Wall particles round a box: tanks and channels, closed or open on any side, in two and three dimensions.
#pragma once

#include <imbibe/geometry/fill.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace imbibe {

/// Sides of a box; combine with |. "low" is the side of the smaller coordinate.
enum class Sides : unsigned {
    none = 0,
    x_low = 1,
    x_high = 2,
    y_low = 4,
    y_high = 8,
    z_low = 16,
    z_high = 32,
    x = x_low | x_high, ///< both sides across x
    y = y_low | y_high, ///< both sides across y
    z = z_low | z_high  ///< both sides across z
};

/// Both sets of sides together.
[[nodiscard]] constexpr Sides operator|(Sides a, Sides b) {
    return static_cast<Sides>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}

/// Whether `sides` includes the low (end = 0) or high (end = 1) side across `axis`.
[[nodiscard]] constexpr bool includes(Sides sides, int axis, int end) {
    return (static_cast<unsigned>(sides) >> (2 * axis + end) & 1u) != 0;
}

/// Positions (m) of the wall particles of a tank whose inside is `inner`: `layers` layers on every side that is not in
/// `open`, with corners and edges. The first layer lies half a spacing outside the inner face, the next ones a spacing
/// apart. Open sides (the top, or the two sides across a periodic axis) have no wall; the walls beside them end at the
/// inner face.
///
/// Along a wall the particles are one spacing apart if that side of `inner` is a whole number of spacings, else evenly
/// spread with the nearest whole number of spacings.
///
/// Throws Error if the spacing is not finite and > 0 m or longer than a side of `inner`, layers < 1, all sides are
/// open, or a side across z is named in 2D.
template <int dim>
[[nodiscard]] std::vector<Point<dim>> tank(const Box<dim>& inner, double spacing, int layers,
                                           Sides open = Sides::none) {
    detail::require_positive("tank", "spacing", spacing, "Give the distance between particles in metres.");
    require(inner.bounded(), "tank: the inner box must be bounded. Give two corners.");
    require(layers >= 1 && layers <= 1000, "tank: layers = ", layers,
            " must be from 1 to 1000. As many as the support radius has spacings, rounded up, is usual: 2 to 4.");
    require(static_cast<unsigned>(open) < (1u << (2 * dim)), "tank: a side that a box in ", dim,
            " dimensions does not have is to be open. In 2D name sides across x and y only.");
    require(static_cast<unsigned>(open) + 1 < (1u << (2 * dim)),
            "tank: all sides are open, so there is no wall. Leave at least one side closed.");

    double count = 1;
    for (int axis = 0; axis < dim; ++axis) {
        const double length = inner.size()[axis];
        require(length >= spacing * (1 - detail::on_the_face), "tank: spacing = ", spacing, " m is longer than side ",
                "xyz"[axis], " of the inner box, ", length, " m. Take a smaller spacing.");
        count *= std::round(length / spacing) + 2 * layers;
    }
    require(count <= detail::most_lattice_points, "tank: spacing = ", spacing, " m makes about ", count,
            " lattice points in a box of sides ", point_text<dim>(inner.size()), "; at most ",
            detail::most_lattice_points, " are allowed. Give both in the same unit, metres.");

    struct Place {
        double coordinate;
        bool inside;
    };
    std::array<std::vector<Place>, static_cast<std::size_t>(dim)> places;
    for (int axis = 0; axis < dim; ++axis) {
        const double length = inner.size()[axis];
        const double cells = std::round(length / spacing);
        auto& list = places[static_cast<std::size_t>(axis)];
        if (!includes(open, axis, 0))
            for (int layer = layers; layer-- > 0;)
                list.push_back({inner.lower()[axis] - (layer + 0.5) * spacing, false});
        for (double cell = 0; cell < cells; ++cell)
            list.push_back({inner.lower()[axis] + (cell + 0.5) * (length / cells), true});
        if (!includes(open, axis, 1))
            for (int layer = 0; layer < layers; ++layer)
                list.push_back({inner.upper()[axis] + (layer + 0.5) * spacing, false});
    }

    std::vector<Point<dim>> points;
    std::array<std::size_t, static_cast<std::size_t>(dim)> index{};
    for (;;) {
        Point<dim> point;
        bool inside = true;
        for (int axis = 0; axis < dim; ++axis) {
            const auto slot = static_cast<std::size_t>(axis);
            point[axis] = places[slot][index[slot]].coordinate;
            inside = inside && places[slot][index[slot]].inside;
        }
        if (!inside)
            points.push_back(point);
        std::size_t axis = 0;
        while (axis < dim && ++index[axis] == places[axis].size()) {
            index[axis] = 0;
            ++axis;
        }
        if (axis == dim)
            return points;
    }
}

} // namespace imbibe
