// The engine of a scene: the plan of its composition turned into loops over particles and neighbours.
#pragma once

#include <imbibe/solver/motion.hpp>
#include <imbibe/solver/sweep.hpp>

#include <string>

namespace imbibe::detail {

/// @tparam Scene a Composition
template <int dim, class Real, class Scene>
class IMBIBE_PER_BUILD Engine : public Mover<dim, Real, Scene> {
    using Base = Mover<dim, Real, Scene>;

public:
    template <class P>
    using FieldsOf = typename Base::template FieldsOf<P>;
    template <class P>
    using State = typename Base::template State<P>;
    using Phases = typename Base::Phases;
    using Base::for_each_phase;

    using Composition = Scene;

    /// Evaluates terms in the order of their plan. `dt` is by how much states are advanced, s.
    /// @tparam What which terms: one of Composition::WholeStep, Rates, ...
    template <class What>
    void run(double dt) {
        if constexpr (Scene::valid) {
            step_length = dt;
            clear_sums<What>();
            run_steps<What>(std::make_index_sequence<static_cast<std::size_t>(What::plan.size)>{});
        } else {
            nothing<Scene>(); // that has an error: its loops would have more, and it must not link without them
        }
    }

private:
    double step_length = 0; ///< by how much states are advanced, s

    // Sums start from zero, the acceleration from gravity.
    template <class What>
    void clear_sums() {
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) { clear_fields<What>(s, FieldsOf<P>{}); });
    }
    template <class What, class P, class List, class... F>
    void clear_fields(PhaseState<P, List, dim, Real>& s, TypeList<F...>) {
        const auto clear = [&]<class G>(std::type_identity<G>) {
            constexpr bool starts_from_gravity = What::gravity && std::is_same_v<G, Rate<Velocity>>;
            if constexpr (What::added.test(Scene::template column<P, G>) || starts_from_gravity)
                clear_columns(s.field(G{}), s.stride(), s.size(), components(G::rank, dim), starts_from_gravity);
        };
        (clear(std::type_identity<F>{}), ...);
    }
    [[gnu::noinline]] void clear_columns(Real* first, std::size_t stride, int n, int columns, bool from_gravity) {
        const auto block = [&](int begin, int end) {
            for (int k = 0; k < columns; ++k)
                std::fill_n(first + static_cast<std::size_t>(k) * stride + begin, end - begin,
                            from_gravity ? static_cast<Real>(this->gravity[k % dim]) : Real(0));
        };
        loop_blocks(n, 4096, this->threads, Callable<void(int, int)>(block));
    }

    template <class What, std::size_t... k>
    void run_steps(std::index_sequence<k...>) {
        (run_step<What, static_cast<int>(k)>(), ...);
    }
    template <class What, int k>
    void run_step() {
        constexpr Step step = What::plan.steps[static_cast<std::size_t>(k)];
        using Nodes = typename Pick<What, k, std::make_index_sequence<static_cast<std::size_t>(step.size)>>::type;
        using P = At<step.phase, Phases>;
        if (this->template state<P>().size() == 0)
            return;
        if constexpr (contains<typename Scene::template Advance<P, Density>, Nodes>)
            keep_volume(this->template state<P>(), this->template state<P>().field(density), step_length,
                        box_of<P>(*this), this->threads);
        if constexpr (step.sweep)
            sweep<P>(Nodes{});
        else
            particle_loop<P>(Nodes{});
        this->template state<P>().pad();
    }
    template <class What, int k, class Sequence>
    struct Pick;
    template <class What, int k, std::size_t... r>
    struct Pick<What, k, std::index_sequence<r...>> {
        using type = TypeList<At<What::plan.steps[static_cast<std::size_t>(k)].rows[r], typename What::Rows>...>;
    };

    template <class N>
    const auto& owner() const {
        using Owner = typename N::Owner;
        if constexpr (IsCoupling<Owner>)
            return this->template coupling<Owner>();
        else
            return this->template state<Owner>().material;
    }

    // ---- particle loops ----
    template <class P, class... N>
    void particle_loop(TypeList<N...>) {
        auto& s = this->template state<P>();
        const auto block = [&](int begin, int end) { (particle_block<N>(s, begin, end), ...); };
        loop_blocks(s.size(), 2048, this->threads, Callable<void(int, int)>(block));
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
            using Reads = ReadsOnA<dim, N>;
            using T = Pack<Real, N::in_packs ? Base::width : 1>;
            const P material = s.material;               // a copy, as in a sweep
            for (int i = begin; i < end; i += T::size) { // the last pack goes on into the room behind the particles
                OwnValues<Reads, dim, T> own;
                own.template load_consecutive<FieldsOf<P>>(s.data() + i, s.stride());
                const OwnView<P, Reads, dim, T> a{own, material, this->gravity, step_length};
                if constexpr (is_particle_part<typename N::Part, dim, P>) // or else an error of its own
                    write_results<N, T>(s, i, part(a), Concat<typename N::Sets, typename N::Adds>{});
            }
        }
    }
    template <class N, class T, class S, class R, class... F>
    IMBIBE_INLINE void write_results(S& s, int i, const R& result, TypeList<F...>) {
        const auto one = [&]<class G, class V>(std::type_identity<G>, const V& value) {
            for (int c = 0; c < components(G::rank, dim); ++c) {
                Real* const to = s.column(S::template offset<G> + c) + i;
                const T given(component(value, c));
                (contains<G, typename N::Sets> ? given : T::load(to) + given).store(to);
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
        auto& s = this->template state<P>();
        (refresh_image<N>(), ...);
        const auto sources = std::make_tuple(source_data<P, S>()...);
        const auto parts = std::make_tuple(parts_from(Filter<NodesFrom<S>::template Keep, TypeList<N...>>{})...);
        const bool nothing_near = (source_is_absent<P, S>() && ...);
        if (nothing_near)
            return;
        (++this->template link<P, typename S::B, S::reference>().sweeps, ...);
        const auto block = [&](int begin, int end) {
            sweep_block<P, Adds, TypeList<N...>, S...>(s, sources, parts, begin, end,
                                                       std::make_index_sequence<sizeof...(S)>{});
        };
        loop_blocks(s.size(), search::RunList::smallest_block, this->threads, Callable<void(int, int)>(block));
    }
    template <class P, class Adds, class Nodes, class... S, class Sources, class AllParts, std::size_t... k>
    void sweep_block(State<P>& s, const Sources& sources, const AllParts& parts, int begin, int end,
                     std::index_sequence<k...>) {
        using T = Pack<Real, Base::width>;
        using OwnFields = typename OwnFieldsOf<dim, Nodes>::type;
        // Copies: of the numbers where they are, the compiler of a scene in double must take it that sums are stored
        // over them, and compute what follows from them for every run.
        const P material = s.material;
        const std::tuple<typename S::B...> others{this->template state<typename S::B>().material...};
        const std::array<SupportRadius, sizeof...(S)> supports{SupportRadius(std::get<k>(sources).support)...};
        const AllParts own_parts = parts;
        const Vector<double, dim> gravity_now = this->gravity;
        std::array<search::RunList::Walk, sizeof...(S)> walks{
            search::RunList::Walk(*std::get<k>(sources).runs, begin)...};
        for (int i = begin; i < end; ++i) {
            Sums<Adds, dim, T> sums;
            for (T& t : sums.total)
                t = T(0);
            OwnValues<OwnFields, dim, T> own;
            own.template load<FieldsOf<P>>(s.data() + i, s.stride());
            const OwnView<P, OwnFields, dim, T> a{own, material, gravity_now, step_length};
            (gather<S, FieldsOf<typename S::B>>(
                 Filter<NodesFrom<S>::template Keep, Nodes>{},
                 std::make_index_sequence<std::tuple_size_v<std::tuple_element_t<k, AllParts>>>{}, sums, s, a,
                 std::get<k>(sources), supports[k], std::get<k>(others), i, walks[k].next(), std::get<k>(own_parts)),
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
        return this->template link<P, typename S::B, S::reference>().runs.is_empty();
    }
    template <class P, class S>
    SourceData<dim, FieldsOf<typename S::B>, Real, Base::width> source_data() const {
        const auto& b = this->template state<typename S::B>();
        const auto& l = this->template link<P, typename S::B, S::reference>();
        SourceData<dim, FieldsOf<typename S::B>, Real, Base::width> source{};
        for (std::size_t k = 0; k < source.columns.size(); ++k)
            if constexpr (State<typename S::B>::keeps_reference && !S::reference)
                source.columns[k] = b.image_column(static_cast<int>(k));
            else
                source.columns[k] = b.column(static_cast<int>(k));
        source.runs = &l.runs;
        source.support = l.support;
        source.least_distances = LeastDistances<Real, Base::width>(l.support);
        for (int shift = 0; shift < search::image_count<dim>; ++shift)
            for (int d = 0; d < dim; ++d)
                source.images[static_cast<std::size_t>(shift)][d] = static_cast<Real>(
                    search::image_step(shift, d) * this->periodic.length[static_cast<std::size_t>(d)]);
        return source;
    }
    // A total-Lagrangian phase is seen by others through a copy: brings the fields a node reads there up to date.
    template <class N>
    void refresh_image() {
        using B = typename N::B;
        if constexpr (State<B>::keeps_reference && !N::reference) {
            if (!this->template link<typename N::A, B, false>().runs.is_empty())
                copy_fields<B>(ReadsOnB<dim, N>{});
        }
    }
    template <class B, class... F>
    void copy_fields([[maybe_unused]] TypeList<F...> fields) {
        (copy_field<B, F>(), ...);
    }
    template <class B, class F>
    void copy_field() {
        if constexpr (!std::is_same_v<F, Position>) // which are there, as others see them
            this->template state<B>().copy_to_image(State<B>::template offset<F>, components(F::rank, dim),
                                                    this->threads);
    }
};

} // namespace imbibe::detail
