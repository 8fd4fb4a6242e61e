// Checks new particles in a scene: no two in one place, neither among themselves nor with existing ones, also across
// periodic sides.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/geometry/distinct.hpp>
#include <imbibe/search/grid.hpp>

#include <string>
#include <utility>
#include <vector>

namespace imbibe::detail {

/// The places, with copies of those at the lower end of a period at its upper end. spacing, m.
template <int dim>
std::vector<Point<dim>> with_images(std::vector<Point<dim>> places, double spacing,
                                    const search::Periodic<dim>& periodic) {
    for (int d = 0; d < dim; ++d) {
        const double length = periodic.length[static_cast<std::size_t>(d)],
                     lower = periodic.lower[static_cast<std::size_t>(d)];
        if (length > 0)
            for (std::size_t k = 0, n = places.size(); k < n; ++k)
                if (places[k][d] < lower + 1e-3 * spacing)
                    places.push_back(places[k] + length * Point<dim>::Unit(d));
    }
    return places;
}

/// The new places, and those of the `count` particles at place(i) that may be too near to one of them: in the box
/// around the new ones, or a period beside it. spacing, m.
template <int dim>
std::vector<Point<dim>> with_particles_near(const std::vector<Point<dim>>& added, int count, const auto& place,
                                            double spacing, const search::Periodic<dim>& periodic) {
    Point<dim> low = added.front(), high = low;
    for (const Point<dim>& x : added) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    low.array() -= 2e-3 * spacing; // twice the least distance, because of rounding
    high.array() += 2e-3 * spacing;
    std::vector<Point<dim>> found = added;
    for (int i = 0; i < count; ++i) {
        const Point<dim> x = place(i);
        bool near_to_added = true;
        for (int d = 0; d < dim; ++d) {
            const double length = periodic.length[static_cast<std::size_t>(d)];
            const auto in_box = [&](double at) { return at >= low[d] && at <= high[d]; };
            near_to_added &= in_box(x[d]) || in_box(x[d] + length) || in_box(x[d] - length);
        }
        if (near_to_added)
            found.push_back(x);
    }
    return found;
}

/// Throws Error, which begins with the name of the phase, if one of the new places is nearer than 1e-3 spacing (m) to
/// another or to one of the `count` particles at place(i), also through periodic sides. As a source adds a few
/// particles to many, only the existing ones near the new ones are checked; if two coincide, all are, and the error
/// counts them.
template <int dim>
void require_distinct_places(const std::vector<Point<dim>>& added, int count, const auto& place, double spacing,
                             const search::Periodic<dim>& periodic, const std::string& name) {
    if (added.empty())
        return;
    try {
        require_distinct<dim>(
            name, with_images(with_particles_near(added, count, place, spacing, periodic), spacing, periodic), spacing);
    } catch (const Error&) {
        std::string who = name;
        for (int d = 0; d < dim; ++d)
            if (const double length = periodic.length[static_cast<std::size_t>(d)]; length > 0)
                who += text(", which repeats every ", length, " m along ", "xyz"[d]);
        std::vector<Point<dim>> all = added;
        for (int i = 0; i < count; ++i)
            all.push_back(place(i));
        require_distinct<dim>(who, with_images(std::move(all), spacing, periodic), spacing);
        throw;
    }
}

} // namespace imbibe::detail
