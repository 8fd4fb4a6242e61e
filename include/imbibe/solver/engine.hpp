// The engine room of a scene: the particles of all phases, their neighbours, and the plan turned into loops.
#pragma once

#include <imbibe/core/parallel.hpp>
#include <imbibe/solver/sweep.hpp>

#include <string>

namespace imbibe::detail {

/// The neighbours of phase A's particles among those of phase B.
template <class A_, class B_, bool reference_>
struct Link {
    using A = A_;
    using B = B_;
    static constexpr bool reference = reference_;
    search::RunList runs;
    double support = 0; ///< m
};

template <int dim, class List>
struct LinksOf;
template <int dim, class... N>
struct LinksOf<dim, TypeList<N...>> {
    using type = Unique<
        Concat<std::conditional_t<is_pair_node<dim, N>, TypeList<Link<typename N::A, typename N::B, N::reference>>,
                                  TypeList<>>...>>;
};

/// How fast a phase moves: the greatest speed, m/s, and the greatest acceleration, m/s^2.
struct Motion {
    double speed = 0, acceleration = 0;
};

/// @tparam Scene a Composition
template <int dim, class Real, class Scene>
class Engine {
public:
    static constexpr int width = native_width<Real>;
    template <class P>
    using FieldsOf = typename Scene::template FieldsOf<P>;
    template <class P>
    using State = PhaseState<P, FieldsOf<P>, dim, Real>;
    using Phases = typename Scene::Phases;
    using Links = typename LinksOf<dim, typename Scene::Nodes>::type;

    Vector<double, dim> gravity{};
    search::Periodic<dim> periodic;
    int threads = 1;

    template <class P>
    State<P>& state() {
        return std::get<State<P>>(states);
    }
    template <class P>
    const State<P>& state() const {
        return std::get<State<P>>(states);
    }
    template <class C>
    C& coupling() {
        return std::get<C>(couplings);
    }
    template <class C>
    const C& coupling() const {
        return std::get<C>(couplings);
    }
    template <class A, class B, bool reference>
    const Link<A, B, reference>& link() const {
        return std::get<Link<A, B, reference>>(links);
    }
    template <class P>
    const Motion& motion() const {
        return motions[static_cast<std::size_t>(Scene::template phase_index<P>)];
    }
    /// H between two phases: the larger of the two.
    template <class A, class B>
    double support() const {
        return std::max(state<A>().material.support_radius, state<B>().material.support_radius);
    }
    /// Calls f(state) for every phase.
    template <class F>
    void for_each_phase(const F& f) {
        each_phase(f, Phases{});
    }
    template <class F>
    void for_each_phase(const F& f) const {
        each_phase(f, Phases{});
    }

    // ---- neighbours ----

    /// Once, when the particles are there: puts total-Lagrangian phases into the order of their reference positions
    /// and finds the neighbours they keep.
    void find_reference_neighbours() {
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            if constexpr (State<P>::keeps_reference) {
                if (s.size() == 0)
                    return;
                const auto bounds = search::bounds_of(s.points_of(reference_position), threads);
                search::Grid<dim> reference_grid;
                reference_grid.fit(bounds, s.material.support_radius, periodic, s.size());
                search::CellTable table;
                if (!table.sort(reference_grid, s.points_of(reference_position), threads))
                    s.reorder(table.order(), threads);
                const auto points = s.points_of(reference_position);
                each_link([&]<class L>(L& link) {
                    if constexpr (L::reference && std::is_same_v<typename L::A, P>) {
                        link.support = s.material.support_radius;
                        search::find_runs<width>(link.runs, points, points, reference_grid, table, link.support, threads);
                    }
                });
            }
        });
    }

    /// In every step: sorts what moves and finds the neighbours of now.
    void find_neighbours() {
        search::Bounds<dim> all;
        long long particles = 0;
        double greatest_support = 0;
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            if (s.size() == 0)
                return;
            if constexpr (State<P>::keeps_reference)
                s.bounds = wrapped(search::bounds_of(s.points(), threads));
            else {
                wrap(s);
                s.bounds = search::bounds_of(s.points(), threads);
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
        grid.fit(all, greatest_support, periodic, particles);
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            if (s.size() > 0 && takes_part<P>())
                sort(s);
            s.pad();
        });
        each_link([&]<class L>(L& link) {
            if constexpr (!L::reference) {
                auto& a = state<typename L::A>();
                auto& b = state<typename L::B>();
                link.support = support<typename L::A, typename L::B>();
                if (a.size() == 0 || b.size() == 0 || are_apart<typename L::A, typename L::B>())
                    link.runs.clear_all(a.size());
                else
                    search::find_runs<width>(link.runs, a.points(), seen_points(b), grid, b.table, link.support, threads);
            }
        });
    }

    // ---- the plan ----

    /// Runs the plan of a step, or the one of what is computed once. `dt` is by how much states are advanced, s.
    template <bool once>
    void run(double dt) {
        step_length = dt;
        clear_sums<once>();
        constexpr auto size = once ? Scene::once_plan.size : Scene::plan.size;
        run_steps<once>(std::make_index_sequence<static_cast<std::size_t>(size)>{});
    }

    // ---- moving ----

    /// velocity += dt * acceleration, for what moves and is not held; measures the motion.
    void kick(double dt) {
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            if constexpr (P::moves) {
                const Real by = static_cast<Real>(dt);
                Real* v = s.field(velocity);
                const Real* a = s.field(acceleration);
                const std::size_t stride = s.stride();
                const Motion start;
                motions[static_cast<std::size_t>(Scene::template phase_index<P>)] = parallel_reduce(
                    s.size(), threads, start,
                    [&](int begin, int end) {
                        Real speed2 = 0, acceleration2 = 0;
                        for (int i = begin; i < end; ++i) {
                            Real free = 1, v2 = 0, a2 = 0;
                            if constexpr (contains<Mobility, FieldsOf<P>>)
                                free = s.field(mobility)[i];
                            for (std::size_t d = 0; d < dim; ++d) {
                                const std::size_t k = d * stride + static_cast<std::size_t>(i);
                                v[k] += by * free * a[k];
                                v2 += v[k] * v[k];
                                a2 += free * a[k] * a[k];
                            }
                            speed2 = std::max(speed2, v2);
                            acceleration2 = std::max(acceleration2, a2);
                        }
                        return Motion{std::sqrt(static_cast<double>(speed2)), std::sqrt(static_cast<double>(acceleration2))};
                    },
                    [](const Motion& a_, const Motion& b_) {
                        return Motion{std::max(a_.speed, b_.speed), std::max(a_.acceleration, b_.acceleration)};
                    });
            }
        });
    }
    /// position += dt * (velocity + transport correction), for what moves and is not held.
    void drift(double dt) {
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            if constexpr (P::moves)
                parallel_blocks(s.size(), 4096, threads, [&](int begin, int end) {
                    const Real by = static_cast<Real>(dt);
                    for (int d = 0; d < dim; ++d) {
                        Real* x = s.column(State<P>::template offset<Position> + d);
                        const Real* v = s.column(State<P>::template offset<Velocity> + d);
                        for (int i = begin; i < end; ++i) {
                            Real speed = v[i];
                            if constexpr (contains<TransportCorrection, FieldsOf<P>>)
                                speed += s.column(State<P>::template offset<TransportCorrection> + d)[i];
                            if constexpr (contains<Mobility, FieldsOf<P>>)
                                speed *= s.field(mobility)[i];
                            x[i] += by * speed;
                        }
                    }
                });
        });
    }

    /// Measures the greatest speed of every phase; its acceleration is at least gravity. For the first step.
    void measure_motion() {
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            auto& m = motions[static_cast<std::size_t>(Scene::template phase_index<P>)];
            m.acceleration = std::max(m.acceleration, std::sqrt(squared_norm(gravity)));
            if constexpr (contains<Velocity, FieldsOf<P>>) {
                double most = 0;
                for (int i = 0; i < s.size(); ++i) {
                    double v2 = 0;
                    for (int d = 0; d < dim; ++d)
                        v2 += sq(static_cast<double>(s.column(State<P>::template offset<Velocity> + d)[i]));
                    most = std::max(most, v2);
                }
                m.speed = std::sqrt(most);
            }
        });
    }
    /// Are the boxes around two phases further apart than their support radius? Never, where sides are periodic.
    template <class A, class B>
    bool are_apart() const {
        return !any_periodic() && state<A>().bounds.far_from(state<B>().bounds, support<A, B>());
    }

    /// Calls f(link) for every pair of phases that have neighbours in each other.
    template <class F>
    void for_each_link(const F& f) const {
        std::apply([&](const auto&... link) { (f(link), ...); }, links);
    }
    /// The mean number of neighbours within the support, the particle itself not counted, over a sample of particles.
    template <class L>
    double mean_neighbours(const L& link) const {
        const auto& a = state<typename L::A>();
        const auto& b = state<typename L::B>();
        if (a.size() == 0 || link.runs.is_empty())
            return 0;
        using Place = std::conditional_t<L::reference, ReferencePosition, Position>;
        const auto targets = a.points_of(Place{});
        const auto sources = L::reference ? b.points_of(Place{}) : seen_points(b);
        const int stride = std::max(1, a.size() / 1000);
        long long found = 0, sampled = 0;
        for (int i = 0; i < a.size(); i += stride, ++sampled)
            for (const search::Run run : link.runs[i])
                for (std::uint32_t j = run.first; j < run.first + run.count; ++j) {
                    double distance2 = 0;
                    for (int d = 0; d < dim; ++d) {
                        const auto k = static_cast<std::size_t>(d);
                        distance2 += sq(static_cast<double>(targets.x[k][i]) -
                                        search::image_step(run.shift, d) * periodic.length[k] -
                                        static_cast<double>(sources.x[k][j]));
                    }
                    found += distance2 > 0 && distance2 < link.support * link.support;
                }
        return static_cast<double>(found) / static_cast<double>(sampled);
    }
    std::size_t particle_bytes() const {
        std::size_t sum = 0;
        for_each_phase([&]<class P>(std::type_identity<P>, const State<P>& s) { sum += s.bytes(); });
        return sum;
    }
    std::size_t list_bytes() const {
        std::size_t sum = 0;
        std::apply([&](const auto&... link) { ((sum += link.runs.bytes()), ...); }, links);
        return sum;
    }

private:
    template <class List>
    struct StatesOf;
    template <class... P>
    struct StatesOf<TypeList<P...>> {
        using type = std::tuple<State<P>...>;
    };
    typename StatesOf<Phases>::type states;
    typename TupleOf<typename Scene::Couplings>::type couplings;
    typename TupleOf<Links>::type links;
    std::array<Motion, static_cast<std::size_t>(Phases::size)> motions{};
    search::Grid<dim> grid;
    double step_length = 0;

    template <class F, class... P>
    void each_phase(const F& f, TypeList<P...>) {
        (f(std::type_identity<P>{}, state<P>()), ...);
    }
    template <class F, class... P>
    void each_phase(const F& f, TypeList<P...>) const {
        (f(std::type_identity<P>{}, state<P>()), ...);
    }
    template <class F>
    void each_link(const F& f) {
        std::apply([&](auto&... link) { (f(link), ...); }, links);
    }

    /// Does any sweep over the neighbours of now involve phase P?
    template <class P>
    static constexpr bool takes_part() {
        return takes_part_in<P>(Links{});
    }
    template <class P, class... L>
    static constexpr bool takes_part_in(TypeList<L...>) {
        return ((!L::reference && (std::is_same_v<P, typename L::A> || std::is_same_v<P, typename L::B>)) || ...);
    }

    bool any_periodic() const {
        return std::any_of(periodic.length.begin(), periodic.length.end(), [](double length) { return length > 0; });
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
        if (periodic.length[k] == 0)
            return;
        const Real low = static_cast<Real>(periodic.lower[k]), length = static_cast<Real>(periodic.length[k]);
        for (int i = 0; i < n; ++i)
            x[i] = search::into_period(x[i], low, length);
    }
    search::Bounds<dim> wrapped(search::Bounds<dim> b) const {
        for (std::size_t d = 0; d < dim; ++d)
            if (periodic.length[d] > 0) {
                b.lower[d] = periodic.lower[d];
                b.upper[d] = periodic.lower[d] + periodic.length[d];
            }
        return b;
    }

    template <class S>
    void sort(S& s) {
        if constexpr (S::keeps_reference) {
            s.image_order.resize(static_cast<std::size_t>(s.size()));
            for (std::size_t i = 0; i < s.image_order.size(); ++i)
                s.image_order[i] = static_cast<std::uint32_t>(i);
            s.copy_to_image(S::template offset<Position>, dim, threads);
            for (int d = 0; d < dim; ++d)
                wrap_column(s.image_column(S::template offset<Position> + d), s.size(), d);
            if (!s.table.sort(grid, s.image_points(), threads)) {
                s.image_order = s.table.order();
                s.copy_to_image(S::template offset<Position>, dim, threads);
                for (int d = 0; d < dim; ++d)
                    wrap_column(s.image_column(S::template offset<Position> + d), s.size(), d);
            }
        } else if (!s.table.sort(grid, s.points(), threads)) {
            s.reorder(s.table.order(), threads);
        }
    }
    template <class S>
    static search::Points<dim, Real> seen_points(const S& s) {
        if constexpr (S::keeps_reference)
            return s.image_points();
        else
            return s.points();
    }

    // Sums start from zero, the acceleration from gravity.
    template <bool once>
    void clear_sums() {
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            clear_fields<once>(s, FieldsOf<P>{});
        });
    }
    template <bool once, class P, class List, class... F>
    void clear_fields(PhaseState<P, List, dim, Real>& s, TypeList<F...>) {
        constexpr Bits added = once ? Scene::added_once : Scene::added_in_step;
        const auto clear = [&]<class G>(std::type_identity<G>) {
            if constexpr (added.test(Scene::template column<P, G>) || (!once && std::is_same_v<G, Rate<Velocity>>))
                parallel_for(components(G::rank, dim), threads, [&](int k) {
                    Real start = 0;
                    if constexpr (std::is_same_v<G, Rate<Velocity>>)
                        start = static_cast<Real>(gravity[k]);
                    std::fill_n(s.column(component_offset<dim, G, List> + k), s.size(), start);
                });
        };
        (clear(std::type_identity<F>{}), ...);
    }

    template <bool once, std::size_t... k>
    void run_steps(std::index_sequence<k...>) {
        (run_step<once, static_cast<int>(k)>(), ...);
    }
    template <bool once, int k>
    void run_step() {
        constexpr Step step = (once ? Scene::once_plan : Scene::plan).steps[static_cast<std::size_t>(k)];
        using Rows = std::conditional_t<once, typename Scene::OnceRows, typename Scene::StepRows>;
        using Nodes = typename Pick<Rows, once, k, std::make_index_sequence<static_cast<std::size_t>(step.size)>>::type;
        using P = At<step.phase, Phases>;
        if (state<P>().size() == 0)
            return;
        if constexpr (step.sweep)
            sweep<P>(Nodes{});
        else
            particle_loop<P>(Nodes{});
        state<P>().pad();
    }
    template <class Rows, bool once, int k, class Sequence>
    struct Pick;
    template <class Rows, bool once, int k, std::size_t... r>
    struct Pick<Rows, once, k, std::index_sequence<r...>> {
        using type = TypeList<
            At<(once ? Scene::once_plan : Scene::plan).steps[static_cast<std::size_t>(k)].rows[r], Rows>...>;
    };

    template <class N>
    const auto& owner() const {
        using Owner = typename N::Owner;
        if constexpr (IsCoupling<Owner>)
            return coupling<Owner>();
        else
            return state<Owner>().material;
    }

    // ---- particle loops ----
    template <class P, class... N>
    void particle_loop(TypeList<N...>) {
        auto& s = state<P>();
        parallel_blocks(s.size(), 2048, threads, [&](int begin, int end) { (particle_block<N>(s, begin, end), ...); });
    }
    template <class N, class S>
    void particle_block(S& s, int begin, int end) {
        if constexpr (Scene::template is_advance<N>) {
            using F = typename N::Field;
            const Real by = static_cast<Real>(step_length);
            for (int c = 0; c < components(F::rank, dim); ++c) {
                Real* x = s.column(S::template offset<F> + c);
                const Real* rate = s.column(S::template offset<Rate<F>> + c);
                for (int i = begin; i < end; ++i)
                    x[i] += by * rate[i];
            }
        } else {
            using P = typename N::A;
            const auto part = make_part<N>(owner<N>());
            for (int i = begin; i < end; ++i) {
                const ParticleView<N, P, FieldsOf<P>, dim, Real, 1, true> a{s.data() + i, s.stride(), s.material,
                                                                            gravity, nullptr};
                write_results<N>(s, i, part(a), Concat<typename N::Sets, typename N::Adds>{});
            }
        }
    }
    template <class N, class S, class R, class... F>
    IMBIBE_INLINE void write_results(S& s, int i, const R& result, TypeList<F...>) {
        const auto one = [&]<class G, class V>(std::type_identity<G>, const V& value) {
            for (int c = 0; c < components(G::rank, dim); ++c) {
                Real& to = s.column(S::template offset<G> + c)[i];
                if constexpr (contains<G, typename N::Sets>)
                    to = static_cast<Real>(component(value, c));
                else
                    to += static_cast<Real>(component(value, c));
            }
        };
        if constexpr (is_tuple<R>)
            std::apply([&](const auto&... value) { (one(std::type_identity<F>{}, value), ...); }, result);
        else
            (one(std::type_identity<F>{}, result), ...);
    }

    // ---- sweeps ----
    template <class P, class... N>
    void sweep(TypeList<N...> nodes) {
        using Adds = typename AddsOfNodes<TypeList<N...>>::type;
        sweep_sources<P, Adds>(nodes, typename SourcesOf<TypeList<N...>>::type{});
    }
    template <class P, class Adds, class... N, class... S>
    void sweep_sources(TypeList<N...>, TypeList<S...>) {
        auto& s = state<P>();
        (refresh_image<N>(), ...);
        const auto sources = std::make_tuple(source_data<P, S>()...);
        const auto parts = std::make_tuple(parts_from(Filter<NodesFrom<S>::template Keep, TypeList<N...>>{})...);
        const bool nothing_near = (source_is_absent<P, S>() && ...);
        if (nothing_near)
            return;
        parallel_blocks(s.size(), search::RunList::block_size, threads, [&](int begin, int end) {
            sweep_block<P, Adds, TypeList<N...>, S...>(s, sources, parts, begin, end,
                                                      std::make_index_sequence<sizeof...(S)>{});
        });
    }
    template <class P, class Adds, class Nodes, class... S, class Sources, class AllParts, std::size_t... k>
    void sweep_block(State<P>& s, const Sources& sources, const AllParts& parts, int begin, int end,
                     std::index_sequence<k...>) {
        using T = Pack<Real, width>;
        for (int i = begin; i < end; ++i) {
            Sums<Adds, dim, T> sums;
            for (T& t : sums.total)
                t = T(0);
            (gather<S, FieldsOf<typename S::B>>(
                 Filter<NodesFrom<S>::template Keep, Nodes>{},
                 std::make_index_sequence<std::tuple_size_v<std::remove_cvref_t<decltype(std::get<k>(parts))>>>{}, sums, s,
                 std::get<k>(sources), state<typename S::B>().material, gravity, i, std::get<k>(parts)),
             ...);
            store<P>(s, i, sums, Adds{});
        }
    }
    template <class P, class Adds, class T, class... F>
    IMBIBE_INLINE void store(State<P>& s, int i, const Sums<Adds, dim, T>& sums, TypeList<F...>) {
        const auto one = [&]<class G>(std::type_identity<G>) {
            for (int c = 0; c < components(G::rank, dim); ++c)
                s.column(State<P>::template offset<G> + c)[i] += sum(sums.total[component_offset<dim, G, Adds> + c]);
        };
        (one(std::type_identity<F>{}), ...);
    }
    template <class... N>
    auto parts_from(TypeList<N...>) const {
        return std::make_tuple(make_part<N>(owner<N>())...);
    }
    template <class P, class S>
    bool source_is_absent() const {
        return link<P, typename S::B, S::reference>().runs.is_empty();
    }
    template <class P, class S>
    SourceData<dim, Real> source_data() const {
        const auto& b = state<typename S::B>();
        const auto& l = link<P, typename S::B, S::reference>();
        SourceData<dim, Real> source{};
        if constexpr (State<typename S::B>::keeps_reference && !S::reference)
            source.data = b.image_data();
        else
            source.data = b.data();
        source.stride = b.stride();
        source.runs = &l.runs;
        source.support = l.support;
        source.periodic = &periodic;
        for (int shift = 0; shift < search::image_count<dim>; ++shift)
            for (int d = 0; d < dim; ++d)
                source.images[static_cast<std::size_t>(shift)][d] = static_cast<Real>(
                    search::image_step(shift, d) * periodic.length[static_cast<std::size_t>(d)]);
        return source;
    }
    // A total-Lagrangian phase is seen by others through a copy: brings the fields a node reads there up to date.
    template <class N>
    void refresh_image() {
        using B = typename N::B;
        if constexpr (State<B>::keeps_reference && !N::reference) {
            if (!link<typename N::A, B, false>().runs.is_empty())
                copy_fields<B>(ReadsOnB<dim, N>{});
        }
    }
    template <class B, class... F>
    void copy_fields([[maybe_unused]] TypeList<F...> fields) {
        (state<B>().copy_to_image(State<B>::template offset<F>, components(F::rank, dim), threads), ...);
    }
};

} // namespace imbibe::detail
