// Who is near whom: sorts the particles of a scene and finds their neighbours, those of now in every step and those of
// the stress-free configuration once.
#pragma once

#include <imbibe/solver/pair_distances.hpp>
#include <imbibe/solver/scene_state.hpp>

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

template <int dim, class Real, class Scene>
class IMBIBE_PER_BUILD Neighbourhood : public SceneState<dim, Real, Scene> {
    using Base = SceneState<dim, Real, Scene>;

public:
    template <class P>
    using State = typename Base::template State<P>;
    using Links = typename Base::Links;
    using Base::for_each_phase;

    /// Once, when the particles are there: puts total-Lagrangian phases into the order of their reference positions
    /// and finds the neighbours they keep.
    void find_reference_neighbours() {
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            if constexpr (State<P>::keeps_reference) {
                if (s.size() == 0)
                    return;
                const auto bounds = search::bounds_of(s.points_of(reference_position), this->threads);
                if (bounds.not_finite >= 0)
                    throw_not_finite(s, bounds.not_finite);
                search::Grid<dim> reference_grid;
                reference_grid.fit(bounds, s.material.support_radius, this->periodic, s.size());
                search::CellTable table;
                if (!table.sort(reference_grid, s.points_of(reference_position), this->threads))
                    s.reorder(table.order(), this->threads);
                const auto points = s.points_of(reference_position);
                this->for_each_link([&]<class L>(L& link) {
                    if constexpr (L::reference && std::is_same_v<typename L::A, P>) {
                        link.support = s.material.support_radius;
                        search::find_runs<Base::width>(link.runs, points, points, reference_grid, table, link.support,
                                                       this->threads);
                    }
                });
            }
        });
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
            measure_nearest(typename Scene::Couplings{});
        }
    }
    /// After particles have moved, if neighbours stay as they are: what others see of them.
    void refresh_places() {
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            if constexpr (State<P>::keeps_reference)
                copy_places_to_image(s);
            s.pad();
        });
    }
    /// The same for phase P, if its own particles look for neighbours where they are now.
    template <class P>
    void refresh_places_among() {
        if constexpr (State<P>::keeps_reference && contains<Link<P, P, false>, Links>)
            copy_places_to_image(this->template state<P>());
    }
    /// Will `find_neighbours` search, if it is called `ahead` calls from now and nothing travels far until then?
    bool search_is_due(int ahead = 1) const {
        double farthest = 0;
        for (double way : travelled)
            farthest = std::max(farthest, way);
        bool disturbed = false;
        for_each_phase([&]<class P>(std::type_identity<P>, const State<P>& s) {
            disturbed = disturbed || s.disturbed;
            if constexpr (!P::moves)
                if (search_interval > 1 && !s.disturbed) // a host may move it
                    farthest = std::max(farthest, s.farthest_since(this->threads));
        });
        return steps_since_search + ahead >= search_interval || disturbed || !(farthest <= farthest_allowed);
    }
    /// Makes the next search due.
    void forget_neighbours() { steps_since_search = search_interval; }

    /// Sorts what moves and finds the neighbours of now.
    void search_neighbours() {
        steps_since_search = 0;
        travelled.fill(0);
        farthest_allowed = std::numeric_limits<double>::infinity();
        search::Bounds<dim> all;
        long long particles = 0;
        double greatest_support = 0;
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            s.bounds = {};
            if (s.size() == 0)
                return;
            if constexpr (State<P>::keeps_reference)
                s.bounds = wrapped(search::bounds_of(s.points(), this->threads));
            else {
                wrap(s);
                s.bounds = search::bounds_of(s.points(), this->threads);
            }
            if (s.bounds.not_finite >= 0)
                throw_not_finite(s, s.bounds.not_finite);
            all.include(s.bounds);
            particles += s.size();
            if (takes_part<P>())
                greatest_support = std::max(greatest_support, s.material.support_radius);
        });
        if (greatest_support == 0)
            return;
        grid.fit(all, reach_of(greatest_support), this->periodic, particles);
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            s.within_reach = is_near_any<P>(Links{});
            if (s.within_reach)
                sort(s);
            if (!P::moves && search_interval > 1)
                s.remember_places();
            s.disturbed = false;
            s.pad();
        });
        this->for_each_link([&]<class L>(L& link) {
            if constexpr (!L::reference) {
                auto& a = this->template state<typename L::A>();
                auto& b = this->template state<typename L::B>();
                link.support = this->template support<typename L::A, typename L::B>();
                farthest_allowed =
                    std::min(farthest_allowed, (search_skin > 0 ? search_skin / 2 : 0.05) * link.support);
                if (this->template are_apart<typename L::A, typename L::B>())
                    link.runs.clear_all(a.size());
                else
                    search::find_runs<Base::width>(link.runs, a.points(), seen_points(b), grid, b.table,
                                                   reach_of(link.support), this->threads);
            }
        });
        measure_nearest(typename Scene::Couplings{});
    }

    /// The distance of the nearest particles of two coupled phases, m, as it was when it was measured last; infinite
    /// where no term asks for it.
    template <class C>
    double nearest_of() const {
        double least = std::numeric_limits<double>::infinity();
        if constexpr (asks_for_nearest(typename C::terms{}))
            this->for_each_link([&]<class L>(const L& link) {
                if constexpr (is_link_of<L, C>)
                    least = std::min(least, link.nearest);
            });
        return least;
    }

    /// How far neighbours are looked for, m.
    double reach_of(double support) const { return (1 + search_skin) * support; }

    /// Are the boxes around two phases further apart than that, along a side that is not periodic? So
    /// is a phase without particles from every other.
    template <class A, class B>
    bool are_apart() const {
        return this->template state<A>().bounds.far_from(this->template state<B>().bounds,
                                                         reach_of(this->template support<A, B>()), this->periodic);
    }

    /// How fast phase P moves: what moves by itself as it was after the last step, walls, which a host moves, as they
    /// are now.
    template <class P>
    Motion motion_now() const {
        Motion now = this->template motion<P>();
        if constexpr (!P::moves) {
            now = velocities_of(this->template state<P>());
            now.acceleration = this->template motion<P>().acceleration;
        }
        return now;
    }

    /// The pairs of a link; as they are now, if no particle was added or removed since the last search.
    template <class L>
    PairDistances<dim, Real, Base::width> pairs_of(const L& link) const {
        const auto& a = this->template state<typename L::A>();
        const auto& b = this->template state<typename L::B>();
        if constexpr (L::reference)
            return {link.runs, a.points_of(reference_position), b.points_of(reference_position), this->periodic,
                    nullptr};
        else // a total-Lagrangian phase is not wrapped
            return {link.runs, a.points(), seen_points(b), this->periodic,
                    State<typename L::A>::keeps_reference && this->any_periodic() ? &a.periods_outside : nullptr};
    }
    /// Calls f(link) with the link of a coupling, if it has one. The link the other way round, which it may have as
    /// well, has the same pairs.
    template <class C, class F>
    void with_link_of(const F& f) const {
        bool done = false;
        this->for_each_link([&]<class L>(const L& link) {
            if constexpr (is_link_of<L, C>) {
                if (!done)
                    f(link);
                done = true;
            }
        });
    }
    /// The mean number of neighbours within the support, the particle itself not counted, over a sample of particles.
    template <class L>
    double mean_neighbours(const L& link) const {
        return pairs_of(link).mean_number(link.support);
    }

protected:
    /// How far the particles of each phase can have travelled since the last search, m.
    std::array<double, static_cast<std::size_t>(Base::Phases::size)> travelled{};

    /// The points of a phase as others see it: in the order of the cells.
    template <class S>
    static search::Points<dim, Real> seen_points(const S& s) {
        if constexpr (S::keeps_reference)
            return s.image_points();
        else
            return s.points();
    }

    /// Brings the positions in the copy through which others see a total-Lagrangian phase up to date, if any can.
    template <class S>
    void copy_places_to_image(S& s) {
        if (s.within_reach)
            s.copy_places_to_image(this->threads);
    }

    /// The speeds and the mean velocity of a phase as it is now; what has no velocities rests.
    template <class P, class List>
    Motion velocities_of(const PhaseState<P, List, dim, Real>& s) const {
        if constexpr (contains<Velocity, List>) {
            const Real* v = s.field(velocity);
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
        } else {
            Motion resting;
            resting.speed = s.size() > 0 ? std::sqrt(squared_norm(this->frame)) : 0;
            return resting;
        }
    }

    /// Chooses the frame in which speeds are measured: that of the walls, at their mean velocity; that of particles
    /// that are held, which rest; and where there are neither, that of the mean of all that moves. Once a step, so that
    /// the speeds of all phases belong to one frame; what moves by itself is taken as it was after the last step.
    void choose_frame() {
        Vector<double, dim> of_walls{}, of_others{};
        double walls = 0, others = 0;
        bool held = false;
        for_each_phase([&]<class P>(std::type_identity<P>, const State<P>& s) {
            const Motion now = motion_now<P>();
            for (int d = 0; d < dim; ++d)
                (P::moves ? of_others : of_walls)[d] += s.size() * now.mean[static_cast<std::size_t>(d)];
            (P::moves ? others : walls) += s.size();
            if constexpr (contains<Mobility, typename Base::template FieldsOf<P>>)
                held = held || std::find(s.field(mobility), s.field(mobility) + s.size(), Real(0)) !=
                                   s.field(mobility) + s.size();
        });
        this->frame = Vector<double, dim>{};
        if (!held && walls + others > 0)
            for (int d = 0; d < dim; ++d) {
                const double mean = walls > 0 ? of_walls[d] / walls : of_others[d] / others;
                this->frame[d] = std::isfinite(mean) ? mean : 0;
            }
    }

private:
    template <class L, class C>
    static constexpr bool is_link_of =
        !L::reference &&
        ((std::is_same_v<typename L::A, typename C::First> && std::is_same_v<typename L::B, typename C::Second>) ||
         (std::is_same_v<typename L::A, typename C::Second> && std::is_same_v<typename L::B, typename C::First>));

    // The distance of the nearest pair of every coupling that asks for it.
    template <class... C>
    void measure_nearest(TypeList<C...>) {
        (measure_nearest_of<C>(), ...);
    }
    template <class C>
    void measure_nearest_of() {
        if constexpr (asks_for_nearest(typename C::terms{})) {
            double nearest = std::numeric_limits<double>::infinity();
            with_link_of<C>([&](const auto& link) {
                if (!link.runs.is_empty())
                    nearest = pairs_of(link).nearest(this->threads);
            });
            this->for_each_link([&]<class L>(L& link) {
                if constexpr (is_link_of<L, C>)
                    link.nearest = nearest;
            });
        }
    }
    search::Grid<dim> grid;
    int steps_since_search = 0;
    double farthest_allowed = 0; ///< m

    /// Does any sweep over the neighbours of now involve phase P?
    template <class P>
    static constexpr bool takes_part() {
        return takes_part_in<P>(Links{});
    }
    template <class P, class... L>
    static constexpr bool takes_part_in(TypeList<L...>) {
        return ((!L::reference && (std::is_same_v<P, typename L::A> || std::is_same_v<P, typename L::B>)) || ...);
    }

    /// Is phase P, at the last search, within reach of any phase that it has a sweep over the neighbours of now with?
    template <class P, class... L>
    bool is_near_any(TypeList<L...>) const {
        [[maybe_unused]] const auto is_near = [&]<class M>(std::type_identity<M>) {
            if constexpr (!M::reference && (std::is_same_v<P, typename M::A> || std::is_same_v<P, typename M::B>))
                return !are_apart<typename M::A, typename M::B>();
            return false;
        };
        return (is_near(std::type_identity<L>{}) || ...);
    }

    template <class S>
    [[noreturn]] void throw_not_finite(const S& s, int i) const {
        throw Error(text("a coordinate of particle ", s.ids[static_cast<std::size_t>(i)], " of phase ",
                         type_name<std::remove_cvref_t<decltype(s.material)>>(),
                         " is not a finite number, or is beyond 1e30 m"));
    }

    // Periodic sides: particles that leave on one side come back on the other.
    template <class S>
    void wrap(S& s) {
        for (int d = 0; d < dim; ++d)
            wrap_column(s.column(S::template offset<Position> + d), s.size(), d);
    }
    void wrap_column(Real* x, int n, int d) {
        const auto k = static_cast<std::size_t>(d);
        if (this->periodic.length[k] == 0)
            return;
        const Real low = static_cast<Real>(this->periodic.lower[k]),
                   length = static_cast<Real>(this->periodic.length[k]);
        for (int i = 0; i < n; ++i)
            x[i] = search::into_period(x[i], low, length);
    }
    search::Bounds<dim> wrapped(search::Bounds<dim> b) const {
        for (std::size_t d = 0; d < dim; ++d)
            if (this->periodic.length[d] > 0) {
                b.lower[d] = this->periodic.lower[d];
                b.upper[d] = this->periodic.lower[d] + this->periodic.length[d];
            }
        return b;
    }

    template <class S>
    void sort(S& s) {
        if constexpr (S::keeps_reference) {
            s.image_order.resize(static_cast<std::size_t>(s.size()));
            for (std::size_t i = 0; i < s.image_order.size(); ++i)
                s.image_order[i] = static_cast<std::uint32_t>(i);
            s.note_periods(this->periodic);
            copy_places_to_image(s);
            if (!s.table.sort(grid, s.image_points(), this->threads)) {
                s.image_order = s.table.order();
                copy_places_to_image(s);
            }
        } else if (!s.table.sort(grid, s.points(), this->threads)) {
            s.reorder(s.table.order(), this->threads);
        }
    }
};

} // namespace imbibe::detail
