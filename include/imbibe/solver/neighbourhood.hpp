// Neighbour lists: sorts the particles of a scene and finds their neighbours, the present ones in every step and those
// of the stress-free configuration once.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/solver/pair_distances.hpp>
#include <imbibe/solver/scene_store.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace imbibe::detail {

/// The motion of n particles from that of blocks, in which `mean` holds the sum of the velocities.
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
    using Base::Base, Base::phase, Base::phases, Base::links, Base::support, Base::support_of;

    /// Called once particles are added: sorts total-Lagrangian phases that have grown by their reference positions and
    /// finds their permanent neighbours.
    void find_reference_neighbours();

    /// Number of steps that neighbour lists serve; see Settings::search_interval.
    int search_interval = 1;
    /// Skin of the lists, as a share of the support radius; see Settings::search_skin.
    double search_skin = 0;

    /// In every step: sorts moving phases and finds the present neighbours, if that is due.
    void find_neighbours();
    /// After particles have moved with unchanged neighbour lists: updates the positions that others see.
    void refresh_places();
    /// The same for one phase, if its own particles have present neighbours among themselves.
    void refresh_places_among(int k);
    /// Will the call of `find_neighbours` that is `ahead` calls from now search, if nothing travels far until then?
    bool search_is_due(int ahead = 1) const;
    /// Makes the next search due.
    void forget_neighbours() { steps_since_search = search_interval; }

    /// Sorts moving phases and finds the present neighbours.
    void search_neighbours();

    /// Search radius, m.
    double reach_of(double support_radius) const { return (1 + search_skin) * support_radius; }

    /// Are the boxes around two phases further apart than any term between them reaches, along a side that is not
    /// periodic? Always true for a phase without particles.
    bool are_apart(int a, int b) const;

    /// How fast a phase moves: for moving phases after the last step; for walls, which a host moves, now.
    Motion motion_now(int k) const;

    /// The pairs of a link with present positions, if no particle was added or removed since the last search.
    Pairs pairs_of(const Link& link) const;
    /// The first link of a coupling, if it has one. A link in the other direction has the same pairs.
    const Link* link_of_coupling(int k) const;
    /// The last measured distance of the nearest particles of a coupling's phases, m; infinite if no term asks for it.
    double nearest_of_coupling(int k) const {
        const bool asked = this->table.couplings[static_cast<std::size_t>(k)].asks_for_nearest;
        const Link* const link = asked ? link_of_coupling(k) : nullptr;
        return link == nullptr ? std::numeric_limits<double>::infinity() : link->nearest;
    }
    /// The mean number of neighbours within the support, the particle itself not counted, over a sample of particles.
    double mean_neighbours(const Link& link) const;

protected:
    /// The speeds and the mean velocity of a phase now; 0 for a phase without velocities.
    Motion velocities_of(const Phase& s) const;

    /// Chooses the frame in which speeds are measured: that of the walls, at their mean velocity; at rest, if particles
    /// are held; without either, that of the mean velocity of all moving particles. Once a step, so that the speeds of
    /// all phases belong to one frame; moving phases count with their velocities after the last step.
    void choose_frame();
    /// Updates the positions of a total-Lagrangian phase that others see, if any phase can see it.
    void refresh_seen_places(int k) {
        if (const Phase& s = phase(k); s.row->keeps_reference() && s.within_reach)
            this->seen_of(k).refresh_places(s, this->threads);
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
    void measure_nearest();
    static bool involves(const Link& link, int k) {
        return !link.row.reference && (link.row.a == k || link.row.b == k);
    }
    // Does any sweep over present neighbours involve the phase?
    bool takes_part(int k) const {
        return std::any_of(links.begin(), links.end(), [&](const Link& link) { return involves(link, k); });
    }
    // Was the phase, at the last search, within reach of any with which it has a sweep over present neighbours?
    bool is_near_any(int k) const {
        return std::any_of(links.begin(), links.end(),
                           [&](const Link& link) { return involves(link, k) && !are_apart(link.row.a, link.row.b); });
    }
    static void require_finite(const Phase& s, const search::Bounds<dim>& bounds);

    // Periodic sides: particles that leave on one side come back on the other.
    void wrap(Phase& s) const;
    search::Bounds<dim> wrapped(search::Bounds<dim> b) const;
    void sort(int k);
};

} // namespace imbibe::detail

#if IMBIBE_READS_CODE
#include <imbibe/solver/neighbourhood_code.hpp>
#endif
