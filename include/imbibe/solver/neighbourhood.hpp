// Who is near whom: sorts the particles of a scene and finds their neighbours, those of now in every step and those of
// the stress-free configuration once.
#pragma once

#include <imbibe/core/compiled_core.hpp>
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
    using Base::Base, Base::phase, Base::phases, Base::links, Base::support, Base::support_of;

    /// Once, when the particles are there: puts total-Lagrangian phases that have grown into the order of their
    /// reference positions and finds the neighbours they keep.
    void find_reference_neighbours();

    /// How many steps neighbours serve; see Settings::search_interval.
    int search_interval = 1;
    /// How much further than the support radius they are looked for, as a share of it; see Settings::search_skin.
    double search_skin = 0;

    /// In every step: sorts what moves and finds the neighbours of now, if it is due.
    void find_neighbours();
    /// After particles have moved, if neighbours stay as they are: what others see of them.
    void refresh_places();
    /// The same for one phase, if its own particles look for neighbours where they are now.
    void refresh_places_among(int k);
    /// Will `find_neighbours` search, if it is called `ahead` calls from now and nothing travels far until then?
    bool search_is_due(int ahead = 1) const;
    /// Makes the next search due.
    void forget_neighbours() { steps_since_search = search_interval; }

    /// Sorts what moves and finds the neighbours of now.
    void search_neighbours();

    /// How far neighbours are looked for, m.
    double reach_of(double support_radius) const { return (1 + search_skin) * support_radius; }

    /// Are the boxes around two phases further apart than any term between them reaches, along a side that is not
    /// periodic? So is a phase without particles from every other.
    bool are_apart(int a, int b) const;

    /// How fast a phase moves: what moves by itself as it was after the last step, walls, which a host moves, as they
    /// are now.
    Motion motion_now(int k) const;

    /// The pairs of a link; as they are now, if no particle was added or removed since the last search.
    Pairs pairs_of(const Link& link) const;
    /// The first link of a coupling, if it has one. The link the other way round, which it may have as well, has the
    /// same pairs.
    const Link* link_of_coupling(int k) const;
    /// The distance of the nearest particles of a coupling's phases, m, as it was when it was measured last; infinite
    /// where no term asks for it.
    double nearest_of_coupling(int k) const {
        const bool asked = this->table.couplings[static_cast<std::size_t>(k)].asks_for_nearest;
        const Link* const link = asked ? link_of_coupling(k) : nullptr;
        return link == nullptr ? std::numeric_limits<double>::infinity() : link->nearest;
    }
    /// The mean number of neighbours within the support, the particle itself not counted, over a sample of particles.
    double mean_neighbours(const Link& link) const;

protected:
    /// The speeds and the mean velocity of a phase as it is now; what has no velocities rests.
    Motion velocities_of(const Phase& s) const;

    /// Chooses the frame in which speeds are measured: that of the walls, at their mean velocity; that of particles
    /// that are held, which rest; and where there are neither, that of the mean of all that moves. Once a step, so that
    /// the speeds of all phases belong to one frame; what moves by itself is taken as it was after the last step.
    void choose_frame();
    /// Brings what others see of the positions of a total-Lagrangian phase up to date, if any can.
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
    // Does any sweep over the neighbours of now involve the phase?
    bool takes_part(int k) const {
        return std::any_of(links.begin(), links.end(), [&](const Link& link) { return involves(link, k); });
    }
    // Is the phase, at the last search, within reach of any that it has a sweep over the neighbours of now with?
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
