// Who is near whom: sorts the particles of a scene and finds their neighbours, those of now in every step and those of
// the stress-free configuration once.
#pragma once

#include <imbibe/solver/pair_distances.hpp>
#include <imbibe/solver/scene_store.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace imbibe::detail {

/// The motion of n particles from that of blocks, which have the sum of the velocities for their mean.
[[gnu::noinline]] IMBIBE_PER_BUILD inline Motion motion_of_blocks(int n, int threads,
                                                                  const Callable<Motion(int, int)>& of_block) {
    Motion all = parallel_reduce(n, threads, Motion{}, of_block, [](const Motion& one, const Motion& other) {
        return Motion{std::max(one.speed, other.speed),
                      std::max(one.acceleration, other.acceleration),
                      std::max(one.fastest, other.fastest),
                      {one.mean[0] + other.mean[0], one.mean[1] + other.mean[1], one.mean[2] + other.mean[2]}};
    });
    for (double& component : all.mean)
        component /= std::max(n, 1);
    return all;
}

template <int dim, class Real>
class IMBIBE_PER_BUILD Neighbourhood : public SceneStore<dim, Real> {
    using Base = SceneStore<dim, Real>;

public:
    using Phase = typename Base::Phase;
    using Pairs = PairDistances<dim, Real, Base::width>;
    using Base::Base, Base::phase, Base::phases, Base::links, Base::support;

    /// Once, when the particles are there: puts total-Lagrangian phases into the order of their reference positions
    /// and finds the neighbours they keep.
    void find_reference_neighbours() {
        for (std::size_t k = 0; k < phases.size(); ++k) {
            Phase& s = phases[k];
            if (!s.row->keeps_reference() || s.size() == 0)
                continue;
            const auto places = [&] { return s.points_of(s.row->reference_position); };
            const double reach = s.numbers().support_radius;
            const auto bounds = search::bounds_of(places(), this->threads);
            require_finite(s, bounds);
            search::Grid<dim> reference_grid;
            reference_grid.fit(bounds, reach, this->periodic, s.size());
            search::CellTable cells;
            if (!cells.sort(reference_grid, places(), this->threads)) {
                s.reorder(cells.order(), this->threads);
                s.note_all_written();
            }
            for (Link& link : links)
                if (link.row.reference && link.row.a == static_cast<int>(k)) {
                    link.support = reach;
                    search::find_runs<Base::width>(link.runs, places(), places(), reference_grid, cells, link.support,
                                                   this->threads);
                }
        }
    }

    /// How many steps neighbours serve; see Settings::search_interval.
    int search_interval = 1;
    /// How much further than the support radius they are looked for, as a share of it; see Settings::search_skin.
    double search_skin = 0;

    /// In every step: sorts what moves and finds the neighbours of now, if it is due.
    void find_neighbours() {
        choose_frame();
        ++steps_since_search;
        if (search_is_due(0)) {
            search_neighbours();
        } else {
            refresh_places();
            measure_nearest();
        }
    }
    /// After particles have moved, if neighbours stay as they are: what others see of them.
    void refresh_places() {
        for (Phase& s : phases) {
            copy_places_to_image(s);
            s.pad();
        }
    }
    /// The same for one phase, if its own particles look for neighbours where they are now.
    void refresh_places_among(int k) {
        if (std::any_of(links.begin(), links.end(),
                        [&](const Link& link) { return !link.row.reference && link.row.a == k && link.row.b == k; }))
            copy_places_to_image(phase(k));
    }
    /// Will `find_neighbours` search, if it is called `ahead` calls from now and nothing travels far until then?
    bool search_is_due(int ahead = 1) const {
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
    /// Makes the next search due.
    void forget_neighbours() { steps_since_search = search_interval; }

    /// Sorts what moves and finds the neighbours of now.
    void search_neighbours() {
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
        if (greatest_support == 0)
            return;
        grid.fit(all, reach_of(greatest_support), this->periodic, particles);
        for (std::size_t k = 0; k < phases.size(); ++k) {
            Phase& s = phases[k];
            s.within_reach = is_near_any(static_cast<int>(k));
            if (s.within_reach)
                sort(s);
            if (!s.row->moves && search_interval > 1)
                s.remember_places();
            s.disturbed = false;
            s.pad();
        }
        for (Link& link : links) {
            if (link.row.reference)
                continue;
            const Phase &a = phase(link.row.a), &b = phase(link.row.b);
            link.support = support(link.row.a, link.row.b);
            farthest_allowed = std::min(farthest_allowed, (search_skin > 0 ? search_skin / 2 : 0.05) * link.support);
            if (are_apart(link.row.a, link.row.b))
                link.runs.clear_all(a.size());
            else
                search::find_runs<Base::width>(link.runs, a.points(), b.seen_points(), grid, b.table,
                                               reach_of(link.support), this->threads);
        }
        measure_nearest();
    }

    /// How far neighbours are looked for, m.
    double reach_of(double support_radius) const { return (1 + search_skin) * support_radius; }

    /// Are the boxes around two phases further apart than that, along a side that is not periodic? So
    /// is a phase without particles from every other.
    bool are_apart(int a, int b) const {
        return phase(a).bounds.far_from(phase(b).bounds, reach_of(support(a, b)), this->periodic);
    }

    /// How fast a phase moves: what moves by itself as it was after the last step, walls, which a host moves, as they
    /// are now.
    Motion motion_now(int k) const {
        const Phase& s = phase(k);
        if (s.row->moves)
            return s.motion;
        Motion now = velocities_of(s);
        now.acceleration = s.motion.acceleration;
        return now;
    }

    /// The pairs of a link; as they are now, if no particle was added or removed since the last search.
    Pairs pairs_of(const Link& link) const {
        const Phase &a = phase(link.row.a), &b = phase(link.row.b);
        if (link.row.reference)
            return {link.runs, a.points_of(a.row->reference_position), b.points_of(b.row->reference_position),
                    this->periodic, nullptr};
        // a total-Lagrangian phase is not wrapped
        return {link.runs, a.points(), b.seen_points(), this->periodic,
                a.row->keeps_reference() && this->any_periodic() ? &a.periods_outside : nullptr};
    }
    /// The first link of a coupling, if it has one. The link the other way round, which it may have as well, has the
    /// same pairs.
    const Link* link_of_coupling(int k) const {
        const CouplingRow& coupling = this->table.couplings[static_cast<std::size_t>(k)];
        for (const Link& link : links)
            if (ties(link, coupling))
                return &link;
        return nullptr;
    }
    /// The distance of the nearest particles of a coupling's phases, m, as it was when it was measured last; infinite
    /// where no term asks for it.
    double nearest_of_coupling(int k) const {
        const Link* const link = link_of_coupling(k);
        return link == nullptr ? std::numeric_limits<double>::infinity() : link->nearest;
    }
    /// The mean number of neighbours within the support, the particle itself not counted, over a sample of particles.
    double mean_neighbours(const Link& link) const { return pairs_of(link).mean_number(link.support); }

protected:
    /// The speeds and the mean velocity of a phase as it is now; what has no velocities rests.
    Motion velocities_of(const Phase& s) const {
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

    /// Chooses the frame in which speeds are measured: that of the walls, at their mean velocity; that of particles
    /// that are held, which rest; and where there are neither, that of the mean of all that moves. Once a step, so that
    /// the speeds of all phases belong to one frame; what moves by itself is taken as it was after the last step.
    void choose_frame() {
        Vector<double, dim> of_walls{}, of_others{};
        double walls = 0, others = 0;
        bool held = false;
        for (std::size_t k = 0; k < phases.size(); ++k) {
            const Phase& s = phases[k];
            const Motion now = motion_now(static_cast<int>(k));
            for (int d = 0; d < dim; ++d)
                (s.row->moves ? of_others : of_walls)[d] += s.size() * now.mean[static_cast<std::size_t>(d)];
            (s.row->moves ? others : walls) += s.size();
            if (const Real* const free = s.column_if(s.row->mobility))
                held = held || std::find(free, free + s.size(), Real(0)) != free + s.size();
        }
        this->frame = Vector<double, dim>{};
        if (!held && walls + others > 0)
            for (int d = 0; d < dim; ++d) {
                const double mean = walls > 0 ? of_walls[d] / walls : of_others[d] / others;
                this->frame[d] = std::isfinite(mean) ? mean : 0;
            }
    }
    /// Brings the positions in the copy through which others see a total-Lagrangian phase up to date, if any can.
    void copy_places_to_image(Phase& s) {
        if (s.row->keeps_reference() && s.within_reach)
            s.copy_places_to_image(this->threads);
    }

private:
    search::Grid<dim> grid;
    int steps_since_search = 0;
    double farthest_allowed = 0; ///< m

    static bool ties(const Link& link, const CouplingRow& coupling) {
        const LinkRow& row = link.row;
        return !row.reference && ((row.a == coupling.first && row.b == coupling.second) ||
                                  (row.a == coupling.second && row.b == coupling.first));
    }
    // The distance of the nearest pair of every coupling that asks for it.
    void measure_nearest() {
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
    static bool involves(const Link& link, int k) {
        return !link.row.reference && (link.row.a == k || link.row.b == k);
    }
    // Does any sweep over the neighbours of now involve the phase?
    bool takes_part(int k) const {
        return std::any_of(links.begin(), links.end(), [&](const Link& link) { return involves(link, k); });
    }
    // Is the phase, at the last search, within reach of any that it has a sweep over the neighbours of now with?
    bool is_near_any(int k) const {
        return std::any_of(links.begin(), links.end(),
                           [&](const Link& link) { return involves(link, k) && !are_apart(link.row.a, link.row.b); });
    }
    static void require_finite(const Phase& s, const search::Bounds<dim>& bounds) {
        if (bounds.not_finite >= 0)
            throw Error(text("a coordinate of particle ", s.ids[static_cast<std::size_t>(bounds.not_finite)],
                             " of phase ", s.name, " is not a finite number, or is beyond 1e30 m"));
    }

    // Periodic sides: particles that leave on one side come back on the other.
    void wrap(Phase& s) const {
        for (int d = 0; d < dim; ++d) {
            const auto k = static_cast<std::size_t>(d);
            if (this->periodic.length[k] == 0)
                continue;
            const Real low = static_cast<Real>(this->periodic.lower[k]),
                       length = static_cast<Real>(this->periodic.length[k]);
            Real* const x = s.column(s.row->position + d);
            for (int i = 0; i < s.size(); ++i)
                x[i] = search::into_period(x[i], low, length);
        }
    }
    search::Bounds<dim> wrapped(search::Bounds<dim> b) const {
        for (std::size_t d = 0; d < dim; ++d)
            if (this->periodic.length[d] > 0) {
                b.lower[d] = this->periodic.lower[d];
                b.upper[d] = this->periodic.lower[d] + this->periodic.length[d];
            }
        return b;
    }
    void sort(Phase& s) {
        if (s.row->keeps_reference())
            s.sort_image(grid, this->periodic, this->threads);
        else if (!s.table.sort(grid, s.points(), this->threads))
            s.reorder(s.table.order(), this->threads);
    }
};

} // namespace imbibe::detail
