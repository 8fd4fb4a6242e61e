// The code of population.hpp: checks new particles and adds them.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/solver/distinct_places.hpp>
#include <imbibe/solver/joined_bodies.hpp>
#include <imbibe/solver/population.hpp>

#include <cmath>
#include <type_traits>

namespace imbibe::detail {

// Throws Error if a particle would see a neighbour twice through a periodic side.
template <int dim, class Real>
void require_within_periods(const Neighbourhood<dim, Real>& scene, double support, const std::string& name) {
    for (const double length : scene.periodic.length)
        require(length == 0 || length >= scene.reach_of(support), name, ": support_radius = ", support,
                " m, with its skin ", scene.reach_of(support), " m, is longer than a period of ", length,
                " m; a particle would see its neighbours twice");
}

template <int dim, class Real>
void require_support(const Neighbourhood<dim, Real>& scene, double support, const std::string& name) {
    require(std::isfinite(support) && support > 0, name, ": support_radius = ", support,
            " m; it must be a finite number above 0 m (or 0: the scene's), usually 2 to 3 particle spacings");
    require_within_periods(scene, support, name);
}

template <int dim, class Real>
void require_supports_of_terms(const Neighbourhood<dim, Real>& scene) {
    for (const Link& link : scene.links) {
        const LinkRow& row = link.row;
        if (row.support_of_term == nullptr || scene.phase(row.a).size() == 0 || scene.phase(row.b).size() == 0)
            continue;
        const std::string name = text(row.coupling < 0 ? scene.phase(row.a).name
                                                       : scene.coupling_names[static_cast<std::size_t>(row.coupling)],
                                      ", ", row.term());
        const double support = scene.support_of(row);
        require(std::isfinite(support) && support > 0, name, ": the term reaches ", support,
                " m; it must reach a finite number above 0 m, by its coefficients and the particle spacing");
        require_within_periods(scene, support, name);
    }
}

template <int dim, class Real>
std::vector<Point<dim>> places_of_new(const Neighbourhood<dim, Real>& scene, int phase,
                                      const std::vector<Point<dim>>& points, double spacing, double support,
                                      const Origin<dim>& origin) {
    const PhaseStore<dim, Real>& s = scene.phase(phase);
    for (std::size_t k = 0; k < points.size(); ++k)
        for (int d = 0; d < dim; ++d)
            require(std::isfinite(points[k][d]), s.name, ": coordinate ", d, " of point ", k, " is ", points[k][d],
                    "; all coordinates must be finite numbers, m");
    require(static_cast<double>(s.size()) + static_cast<double>(points.size()) < 0x1p31, s.name, ": ", points.size(),
            " points for a phase of ", s.size(), " particles; at most 2^31 - 1 are possible");
    if (std::is_same_v<Real, float>) // products of two volumes are formed
        require(std::pow(spacing, 2 * dim) > 1e-37 && std::pow(spacing, 2 * dim) < 1e26, s.name,
                ": spacing = ", spacing, " m; in float it must be between ", std::pow(1e-37, 0.5 / dim), " and ",
                std::pow(1e26, 0.5 / dim), " m. Take double");
    std::vector<Point<dim>> places = points;
    for (Point<dim>& x : places)
        for (int d = 0; d < dim; ++d) {
            const auto axis = static_cast<std::size_t>(d);
            const double lower = scene.periodic.lower[axis], length = scene.periodic.length[axis];
            x[d] -= origin[axis];
            if (length > 0)
                x[d] = search::into_period(x[d], lower, length);
            Real rounded = static_cast<Real>(x[d]);
            if (length > 0)
                rounded = search::into_period(rounded, static_cast<Real>(lower), static_cast<Real>(length));
            x[d] = static_cast<double>(rounded);
        }
    const auto place_in = [&s](int first) {
        return [&s, first](int i) {
            Point<dim> x;
            for (int d = 0; d < dim; ++d)
                x[d] = static_cast<double>(s.column(first + d)[i]);
            return x;
        };
    };
    const auto now = place_in(s.row->position);
    require_distinct_places<dim>(places, s.size(), now, spacing, scene.periodic, s.name);
    if (std::any_of(scene.links.begin(), scene.links.end(),
                    [&](const Link& link) { return link.row.reference && link.row.a == phase; }))
        require_unstrained_neighbours<dim>(places, s.size(), place_in(s.row->reference_position), now, support,
                                           scene.periodic, Eigen::Map<const Point<dim>>(origin.data()), s.name);
    return places;
}

// Particles from `before` on are free of stress and not held, with the density of their material and the mass of a
// cell.
template <int dim, class Real>
void set_up_new(PhaseStore<dim, Real>& phase, int before, double density, double spacing) {
    const PhaseRow& row = *phase.row;
    const double cell = dim == 2 ? spacing * spacing : spacing * spacing * spacing;
    const auto set = [&](int column, double value) {
        if (column >= 0)
            std::fill(phase.column(column) + before, phase.column(column) + phase.size(), static_cast<Real>(value));
    };
    set(row.mass, density * cell);
    set(row.density, density);
    set(row.mobility, 1);
    phase.grown = true;
}

template <int dim, class Real>
void add_particles(PhaseStore<dim, Real>& phase, const std::vector<Point<dim>>& places, double density,
                   double spacing) {
    const PhaseRow& row = *phase.row;
    const int before = phase.size(), after = before + static_cast<int>(places.size());
    phase.resize(after);
    set_up_new(phase, before, density, spacing);
    for (int first : {row.position, row.reference_position})
        for (int d = 0; d < dim && first >= 0; ++d)
            for (int i = before; i < after; ++i)
                phase.column(first + d)[i] = static_cast<Real>(places[static_cast<std::size_t>(i - before)][d]);
}

template <int dim, class Real>
std::vector<Handed> hand_over(PhaseStore<dim, Real>& from, PhaseStore<dim, Real>& to, const std::vector<char>& which) {
    const PhaseNumbers before = from.numbers(), now = to.numbers();
    require(now.spacing > 0, to.name, " is to get particles of ", from.name,
            " and was not given its material; add none of it: scene.add(", to.name, "{{...}}, {}, ", before.spacing,
            ")");
    std::vector<char> stays(which.size(), 1);
    std::vector<int> leaving;
    for (std::size_t i = 0; i < which.size(); ++i)
        if (which[i]) {
            stays[i] = 0;
            leaving.push_back(static_cast<int>(i));
        }
    if (leaving.empty())
        return {};
    const int first = to.size();
    to.resize(first + static_cast<int>(leaving.size()));
    set_up_new(to, first, now.density, now.spacing);
    for (const FieldRow& field : to.row->fields)
        for (const FieldRow& other : from.row->fields)
            if (field.name == other.name && field.unit == other.unit && field.components == other.components)
                for (int k = 0; k < field.components; ++k)
                    for (std::size_t i = 0; i < leaving.size(); ++i)
                        to.column(field.first + k)[static_cast<std::size_t>(first) + i] =
                            from.column(other.first + k)[leaving[i]];
    const Real ratio = static_cast<Real>(now.density / before.density);
    for (const int column : {to.row->density, to.row->density_rate})
        for (int i = first; i < to.size() && column >= 0; ++i)
            to.column(column)[i] *= ratio;
    std::vector<Handed> handed;
    for (std::size_t i = 0; i < leaving.size(); ++i)
        handed.push_back({from.ids[static_cast<std::size_t>(leaving[i])], to.ids[static_cast<std::size_t>(first) + i]});
    from.compress(stays);
    return handed;
}

} // namespace imbibe::detail
