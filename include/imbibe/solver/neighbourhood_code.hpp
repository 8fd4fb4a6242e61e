// The code of neighbourhood.hpp: sorts particles and finds their neighbours.
#pragma once

#include <imbibe/solver/neighbourhood.hpp>

namespace imbibe::detail {

template <int dim, class Real>
void Neighbourhood<dim, Real>::find_reference_neighbours() {
    for (std::size_t k = 0; k < phases.size(); ++k) {
        Phase& s = phases[k];
        if (!s.row->keeps_reference() || s.size() == 0 || !s.grown)
            continue;
        const auto places = s.points_of(s.row->reference_position);
        require_finite(s, search::bounds_of(places, this->threads));
        const PhaseNumbers numbers = s.numbers();
        const auto lists = search::find_fixed_lists<Base::width>(places, numbers.support_radius, numbers.spacing,
                                                                 this->periodic, this->threads);
        s.reorder(lists.order, this->threads);
        s.note_all_written();
        for (Link& link : links)
            if (link.row.reference && link.row.a == static_cast<int>(k)) {
                link.support = numbers.support_radius;
                link.runs = lists.runs;
                link.stencils = lists.stencils;
            }
    }
}

template <int dim, class Real>
void Neighbourhood<dim, Real>::find_neighbours() {
    choose_frame();
    ++steps_since_search;
    if (search_is_due(0)) {
        search_neighbours();
    } else {
        refresh_places();
        measure_nearest();
    }
}

template <int dim, class Real>
void Neighbourhood<dim, Real>::refresh_places() {
    for (std::size_t k = 0; k < phases.size(); ++k) {
        refresh_seen_places(static_cast<int>(k));
        phases[k].pad();
    }
}

template <int dim, class Real>
void Neighbourhood<dim, Real>::refresh_places_among(int k) {
    if (std::any_of(links.begin(), links.end(),
                    [&](const Link& link) { return !link.row.reference && link.row.a == k && link.row.b == k; }))
        refresh_seen_places(k);
}

template <int dim, class Real>
bool Neighbourhood<dim, Real>::search_is_due(int ahead) const {
    double farthest = 0;
    bool disturbed = false;
    for (const Phase& s : phases) {
        farthest = std::max(farthest, s.travelled);
        disturbed = disturbed || s.disturbed;
        if (!s.row->moves && search_interval > 1 && !s.disturbed) // a host may move it
            farthest = std::max(farthest, s.farthest_since(this->threads));
    }
    return steps_since_search + ahead >= search_interval || disturbed || !(farthest <= farthest_allowed);
}

template <int dim, class Real>
void Neighbourhood<dim, Real>::search_neighbours() {
    steps_since_search = 0;
    farthest_allowed = std::numeric_limits<double>::infinity();
    search::Bounds<dim> all;
    long long particles = 0;
    double greatest_support = 0;
    for (std::size_t k = 0; k < phases.size(); ++k) {
        Phase& s = phases[k];
        s.travelled = 0;
        s.bounds = {};
        if (s.size() == 0)
            continue;
        if (s.row->keeps_reference()) {
            s.bounds = wrapped(search::bounds_of(s.points(), this->threads));
        } else {
            wrap(s);
            s.bounds = search::bounds_of(s.points(), this->threads);
        }
        require_finite(s, s.bounds);
        all.include(s.bounds);
        particles += s.size();
        if (takes_part(static_cast<int>(k)))
            greatest_support = std::max(greatest_support, s.numbers().support_radius);
    }
    for (const Link& link : links)
        if (link.row.support_of_term != nullptr && !link.row.reference && phase(link.row.a).size() > 0 &&
            phase(link.row.b).size() > 0)
            greatest_support = std::max(greatest_support, support_of(link.row));
    if (greatest_support == 0)
        return;
    grid.fit(all, reach_of(greatest_support), this->periodic, particles);
    for (std::size_t k = 0; k < phases.size(); ++k) {
        Phase& s = phases[k];
        s.within_reach = is_near_any(static_cast<int>(k));
        if (s.within_reach)
            sort(static_cast<int>(k));
        if (!s.row->moves && search_interval > 1)
            s.remember_places();
        s.disturbed = false;
        s.pad();
    }
    for (Link& link : links) {
        if (link.row.reference)
            continue;
        const Phase &a = phase(link.row.a), &b = phase(link.row.b);
        link.support = support_of(link.row);
        farthest_allowed = std::min(farthest_allowed, (search_skin > 0 ? search_skin / 2 : 0.05) * link.support);
        if (a.bounds.far_from(b.bounds, reach_of(link.support), this->periodic))
            link.runs.clear_all(a.size());
        else
            search::find_runs<Base::width>(link.runs, a.points(), this->seen_points(link.row.b), grid, b.table,
                                           reach_of(link.support), this->threads);
    }
    measure_nearest();
}

template <int dim, class Real>
bool Neighbourhood<dim, Real>::are_apart(int a, int b) const {
    return phase(a).bounds.far_from(phase(b).bounds, reach_of(this->longest_support(a, b)), this->periodic);
}

template <int dim, class Real>
Motion Neighbourhood<dim, Real>::motion_now(int k) const {
    const Phase& s = phase(k);
    if (s.row->moves)
        return s.motion;
    Motion now = velocities_of(s);
    now.acceleration = s.motion.acceleration;
    return now;
}

template <int dim, class Real>
typename Neighbourhood<dim, Real>::Pairs Neighbourhood<dim, Real>::pairs_of(const Link& link) const {
    const Phase &a = phase(link.row.a), &b = phase(link.row.b);
    if (link.row.reference)
        return {link.runs, a.points_of(a.row->reference_position), b.points_of(b.row->reference_position),
                this->periodic, nullptr};
    // a total-Lagrangian phase is not wrapped
    return {link.runs, a.points(), this->seen_points(link.row.b), this->periodic,
            a.row->keeps_reference() && this->any_periodic() ? &this->seen_of(link.row.a).periods_outside() : nullptr};
}

template <int dim, class Real>
const Link* Neighbourhood<dim, Real>::link_of_coupling(int k) const {
    const CouplingRow& coupling = this->table.couplings[static_cast<std::size_t>(k)];
    for (const Link& link : links)
        if (ties(link, coupling))
            return &link;
    return nullptr;
}

template <int dim, class Real>
double Neighbourhood<dim, Real>::mean_neighbours(const Link& link) const {
    return pairs_of(link).mean_number(link.support);
}

template <int dim, class Real>
Motion Neighbourhood<dim, Real>::velocities_of(const Phase& s) const {
    if (s.row->velocity < 0) {
        Motion resting;
        resting.speed = s.size() > 0 ? std::sqrt(squared_norm(this->frame)) : 0;
        return resting;
    }
    const Real* v = s.column(s.row->velocity);
    const auto block = [&](int begin, int end) {
        double most2 = 0, relative2 = 0;
        Motion found;
        for (int i = begin; i < end; ++i) {
            double v2 = 0, r2 = 0;
            for (std::size_t d = 0; d < dim; ++d) {
                const auto now = static_cast<double>(v[d * s.stride() + static_cast<std::size_t>(i)]);
                v2 += sq(now);
                r2 += sq(now - this->frame[static_cast<int>(d)]);
                found.mean[d] += now;
            }
            most2 = std::max(most2, v2);
            relative2 = std::max(relative2, r2);
        }
        found.speed = std::sqrt(relative2);
        found.fastest = std::sqrt(most2);
        return found;
    };
    return motion_of_blocks(s.size(), this->threads, Callable<Motion(int, int)>(block));
}

template <int dim, class Real>
void Neighbourhood<dim, Real>::choose_frame() {
    Vector<double, dim> of_walls{}, of_others{};
    double walls = 0, others = 0;
    bool held = false;
    for (std::size_t k = 0; k < phases.size(); ++k) {
        const Phase& s = phases[k];
        const Motion now = motion_now(static_cast<int>(k));
        for (int d = 0; d < dim; ++d)
            (s.row->moves ? of_others : of_walls)[d] += s.size() * now.mean[static_cast<std::size_t>(d)];
        (s.row->moves ? others : walls) += s.size();
        if (const Real* const free = s.column_if(s.row->mobility); free != nullptr && !held) {
            const auto block = [&](int begin, int end) {
                return std::find(free + begin, free + end, Real(0)) != free + end ? 1.0 : 0.0;
            };
            held = greatest_of_blocks(s.size(), this->threads, Callable<double(int, int)>(block)) > 0;
        }
    }
    this->frame = Vector<double, dim>{};
    if (!held && walls + others > 0)
        for (int d = 0; d < dim; ++d) {
            const double mean = walls > 0 ? of_walls[d] / walls : of_others[d] / others;
            this->frame[d] = std::isfinite(mean) ? mean : 0;
        }
}

template <int dim, class Real>
void Neighbourhood<dim, Real>::measure_nearest() {
    for (std::size_t k = 0; k < this->table.couplings.size(); ++k) {
        const CouplingRow& coupling = this->table.couplings[k];
        if (!coupling.asks_for_nearest)
            continue;
        double nearest = std::numeric_limits<double>::infinity();
        if (const Link* const first = link_of_coupling(static_cast<int>(k)); first && !first->runs.is_empty())
            nearest = pairs_of(*first).nearest(this->threads);
        for (Link& link : links)
            if (ties(link, coupling))
                link.nearest = nearest;
    }
}

template <int dim, class Real>
void Neighbourhood<dim, Real>::require_finite(const Phase& s, const search::Bounds<dim>& bounds) {
    if (bounds.not_finite >= 0)
        throw Error(text("a coordinate of particle ", s.ids[static_cast<std::size_t>(bounds.not_finite)], " of phase ",
                         s.name, " is not a finite number, or is beyond 1e30 m"));
}

template <int dim, class Real>
void Neighbourhood<dim, Real>::wrap(Phase& s) const {
    for (int d = 0; d < dim; ++d) {
        const auto k = static_cast<std::size_t>(d);
        if (this->periodic.length[k] == 0)
            continue;
        const Real low = static_cast<Real>(this->periodic.lower[k]),
                   length = static_cast<Real>(this->periodic.length[k]);
        Real* const x = s.column(s.row->position + d);
        const auto block = [&](int begin, int end) {
            for (int i = begin; i < end; ++i)
                x[i] = search::into_period(x[i], low, length);
        };
        loop_blocks(s.size(), 4096, this->threads, Callable<void(int, int)>(block));
    }
}

template <int dim, class Real>
search::Bounds<dim> Neighbourhood<dim, Real>::wrapped(search::Bounds<dim> b) const {
    for (std::size_t d = 0; d < dim; ++d)
        if (this->periodic.length[d] > 0) {
            b.lower[d] = this->periodic.lower[d];
            b.upper[d] = this->periodic.lower[d] + this->periodic.length[d];
        }
    return b;
}

template <int dim, class Real>
void Neighbourhood<dim, Real>::sort(int k) {
    Phase& s = phase(k);
    if (s.row->keeps_reference())
        this->seen_of(k).sort(s, grid, this->periodic, this->threads);
    else if (!s.table.sort(grid, s.points(), this->threads))
        s.reorder(s.table.order(), this->threads);
}

} // namespace imbibe::detail
