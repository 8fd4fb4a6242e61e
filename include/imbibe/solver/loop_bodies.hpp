// The bodies of the loops: the only run-time code that is compiled for a scene's types. A body computes some particles
// of a phase, by functions of the particle alone or by sums over its neighbours.
#pragma once

#include <imbibe/solver/scene_engine.hpp>
#include <imbibe/solver/sweep.hpp>

#include <tuple>
#include <utility>

namespace imbibe::detail {

/// The neighbours of phase A's particles among those of phase B; see Node.
template <class A_, class B_, bool reference_, class Reach_ = void>
struct LinkType {
    using A = A_;
    using B = B_;
    using Reach = Reach_;
    static constexpr bool reference = reference_;
};

/// The neighbours that some nodes sum over, each once.
template <int dim, class List>
struct LinksOf;
template <int dim, class... N>
struct LinksOf<dim, TypeList<N...>> {
    using type = Unique<Concat<std::conditional_t<
        is_pair_node<dim, N>, TypeList<LinkType<typename N::A, typename N::B, N::reference, typename N::Reach>>,
        TypeList<>>...>>;
};

/// The material of phase P in a running scene.
/// @tparam Scene a Composition
template <class Scene, class P, int dim, class Real>
const P& material_of(const SceneEngine<dim, Real>& engine) {
    return *std::any_cast<P>(&engine.phase(Scene::template phase_index<P>).material);
}
/// What has the coefficients of a node: a phase's material or a coupling.
template <class Scene, class N, int dim, class Real>
const typename N::Owner& owner_of(const SceneEngine<dim, Real>& engine) {
    using Owner = typename N::Owner;
    if constexpr (IsCoupling<Owner>)
        return *std::any_cast<Owner>(
            &engine.couplings[static_cast<std::size_t>(index_of<Owner, typename Scene::Couplings>)]);
    else
        return material_of<Scene, Owner>(engine);
}

/// The nodes of loop k of a pass.
template <class What, int k, class Sequence>
struct PickNodes;
template <class What, int k, std::size_t... r>
struct PickNodes<What, k, std::index_sequence<r...>> {
    using type = TypeList<At<What::plan.steps[static_cast<std::size_t>(k)].rows[r], typename What::Rows>...>;
};
template <class What, int k>
using NodesOfLoop = typename PickNodes<
    What, k,
    std::make_index_sequence<static_cast<std::size_t>(What::plan.steps[static_cast<std::size_t>(k)].size)>>::type;

/// The body of a loop with the given nodes of phase P.
template <int dim, class Real, class Scene, class P>
class IMBIBE_PER_BUILD LoopBody {
    using Engine = SceneEngine<dim, Real>;
    using Phase = PhaseStore<dim, Real>;
    using Fields = typename Scene::template FieldsOf<P>;
    static constexpr int phase = Scene::template phase_index<P>, width = Engine::width;
    template <class F>
    static constexpr int offset = component_offset<dim, F, Fields>;

public:
    /// Functions of the particles themselves, one node after the other.
    template <class... N>
    static void run_on_particles(Engine& engine, int begin, int end, TypeList<N...>) {
        (run_node<N>(engine, engine.phase(phase), begin, end), ...);
    }
    /// Sums over the neighbours from each source.
    template <class Nodes, class... S>
    static void sweep(Engine& engine, int begin, int end, TypeList<S...>) {
        sweep_sources<Nodes, S...>(engine, engine.phase(phase), begin, end, std::make_index_sequence<sizeof...(S)>{});
    }

private:
    template <class N>
    IMBIBE_INLINE static void run_node(const Engine& engine, Phase& s, int begin, int end) {
        if constexpr (is_advance<N>) {
            using F = typename N::Field;
            const Real by = static_cast<Real>(engine.step_length);
            for (int c = 0; c < components(F::rank, dim); ++c) {
                Real* x = s.column(offset<F> + c);
                const Real* rate = s.column(offset<Rate<F>> + c);
                for (int i = begin; i < end; ++i)
                    x[i] += by * rate[i];
            }
        } else {
            const auto part = make_part<N>(owner_of<Scene, N>(engine));
            using Reads = ReadsOnA<dim, N>;
            using T = Pack<Real, N::in_packs ? width : 1>;
            const P material = material_of<Scene, P>(engine); // a copy, as in a sweep
            for (int i = begin; i < end; i += T::size) {      // the last pack runs on into the padding
                OwnValues<Reads, dim, T> own;
                own.template load_consecutive<Fields>(std::as_const(s).data() + i, s.stride());
                const OwnView<P, Reads, dim, T> a{own, material, engine.gravity, engine.step_length, engine.time};
                if constexpr (is_particle_part<typename N::Part, dim, P>) // reported by another rule
                    write_results<N, T>(s, i, part(a), Concat<typename N::Sets, typename N::Adds>{});
            }
        }
    }
    template <class N, class T, class R, class... F>
    IMBIBE_INLINE static void write_results(Phase& s, int i, const R& result, TypeList<F...>) {
        const auto one = [&]<class G, class V>(std::type_identity<G>, const V& value) {
            for (int c = 0; c < components(G::rank, dim); ++c) {
                Real* const to = s.column(offset<G> + c) + i;
                const T given(component(value, c));
                (contains<G, typename N::Sets> ? given : T::load(to) + given).store(to);
            }
        };
        if constexpr (is_tuple<R>)
            std::apply([&](const auto&... value) { (one(std::type_identity<F>{}, value), ...); }, result);
        else
            (one(std::type_identity<F>{}, result), ...);
    }

    template <class S>
    static SourceData<dim, typename Scene::template FieldsOf<typename S::B>, Real, width>
    source_data(const Engine& engine) {
        using B = typename S::B;
        using Links = typename LinksOf<dim, typename Scene::Nodes>::type;
        const Phase& b = engine.phase(Scene::template phase_index<B>);
        const Link& link = engine.link_at(index_of<LinkType<P, B, S::reference, typename S::Reach>, Links>);
        SourceData<dim, typename Scene::template FieldsOf<B>, Real, width> source{};
        for (std::size_t k = 0; k < source.columns.size(); ++k)
            if constexpr (Scene::template keeps_reference<B> && !S::reference)
                source.columns[k] = engine.seen_of(Scene::template phase_index<B>).column(static_cast<int>(k));
            else
                source.columns[k] = b.column(static_cast<int>(k));
        source.runs = &link.runs;
        source.stencils = S::reference ? &link.stencils : nullptr;
        source.support = link.support;
        source.least_distances = LeastDistances<Real, width>(link.support);
        source.images = engine.images;
        return source;
    }
    template <class... N>
    static auto parts_from(const Engine& engine, TypeList<N...>) {
        return std::make_tuple(make_part<N>(owner_of<Scene, N>(engine))...);
    }
    template <class Nodes, class... S, std::size_t... k>
    static void sweep_sources(const Engine& engine, Phase& s, int begin, int end, std::index_sequence<k...> all) {
        const auto sources = std::make_tuple(source_data<S>(engine)...);
        const auto parts = std::make_tuple(parts_from(engine, Filter<NodesFrom<S>::template Keep, Nodes>{})...);
        sweep_block<Nodes, S...>(engine, s, sources, parts, begin, end, all);
    }
    // Not inlined: if the compiler knows that the columns of a source follow from a stride, it computes addresses for
    // every pack instead of loading them.
    template <class Nodes, class... S, class Sources, class AllParts, std::size_t... k>
    [[gnu::noinline]] static void sweep_block(const Engine& engine, Phase& s, const Sources& sources,
                                              const AllParts& all_parts, int begin, int end,
                                              std::index_sequence<k...>) {
        using T = Pack<Real, width>;
        using Adds = typename AddsOfNodes<Nodes>::type;
        using OwnFields = typename OwnFieldsOf<dim, Nodes>::type;
        // Copies: otherwise, in double, the compiler must assume that sums are stored over these numbers, and
        // recomputes what follows from them for every run.
        const P material = material_of<Scene, P>(engine);
        const std::tuple<typename S::B...> others{material_of<Scene, typename S::B>(engine)...};
        const std::array<SupportRadius, sizeof...(S)> supports{SupportRadius(std::get<k>(sources).support)...};
        const AllParts parts = all_parts;
        const Vector<double, dim> gravity_now = engine.gravity;
        const double step_length = engine.step_length, time = engine.time;
        // Particles [from, to) one by one; those of a pack whose fixed neighbours are summed over have only the others.
        const auto one_by_one = [&](int from, int to, [[maybe_unused]] bool others_only) IMBIBE_INLINE_LAMBDA {
            std::array<search::RunList::Walk, sizeof...(S)> walks{
                search::RunList::Walk(*std::get<k>(sources).runs, from)...};
            for (int i = from; i < to; ++i) {
                Sums<Adds, dim, T> sums{};
                OwnValues<OwnFields, dim, T> own;
                own.template load<Fields>(std::as_const(s).data() + i, s.stride());
                const OwnView<P, OwnFields, dim, T> a{own, material, gravity_now, step_length, time};
                (gather<S, typename Scene::template FieldsOf<typename S::B>, P, Fields>(
                     Filter<NodesFrom<S>::template Keep, Nodes>{},
                     std::make_index_sequence<std::tuple_size_v<std::tuple_element_t<k, decltype(parts)>>>{}, sums, s,
                     engine.seen_of(phase), a, std::get<k>(sources), supports[k], std::get<k>(others), i,
                     S::reference && others_only ? search::RunList::Range{} : walks[k].next(), std::get<k>(parts)),
                 ...);
                store(s, i, sums, Adds{}, [](T lanes) { return sum(lanes); });
            }
        };
        if constexpr (width == 1 || !(S::reference || ...)) {
            one_by_one(begin, end, false);
        } else {
            for (int from = begin; from < end; from += width) {
                const bool in_pack = (!std::get<k>(sources).stencil_of(from / width).is_empty() || ...);
                if (in_pack) {
                    Sums<Adds, dim, T> sums{};
                    OwnValues<OwnFields, dim, T> own;
                    own.template load_consecutive<Fields>(std::as_const(s).data() + from, s.stride());
                    const OwnView<P, OwnFields, dim, T> a{own, material, gravity_now, step_length, time};
                    (gather_pack<S, typename Scene::template FieldsOf<typename S::B>, Fields>(
                         Filter<NodesFrom<S>::template Keep, Nodes>{},
                         std::make_index_sequence<std::tuple_size_v<std::tuple_element_t<k, decltype(parts)>>>{}, sums,
                         s, a, std::get<k>(sources), supports[k], std::get<k>(others), from, std::get<k>(parts)),
                     ...);
                    store(s, from, sums, Adds{}, [](T lanes) { return lanes; });
                }
                const int to = std::min(from + width, end);
                if (!in_pack || ((!S::reference && std::get<k>(sources).any_near(from, to)) || ...))
                    one_by_one(from, to, in_pack);
            }
        }
    }
    // Adds the sums of particle i, or of as many from there on as `of_lanes` returns of a pack.
    template <class Adds, class T, class... F>
    IMBIBE_INLINE static void store(Phase& s, int i, const Sums<Adds, dim, T>& sums, TypeList<F...>,
                                    const auto& of_lanes) {
        const auto one = [&]<class G>(std::type_identity<G>) {
            for (int c = 0; c < components(G::rank, dim); ++c) {
                Real* const to = s.column(offset<G> + c) + i;
                const auto more = of_lanes(sums.total[component_offset<dim, G, Adds> + c]);
                if constexpr (std::is_same_v<decltype(more), const T>)
                    (T::load(to) + more).store(to);
                else
                    *to += more;
            }
        };
        (one(std::type_identity<F>{}), ...);
    }
};

/// Computes particles [begin, end) of loop k of a pass.
/// @tparam Scene a Composition, @tparam What one of its passes
template <int dim, class Real, class Scene, class What, int k>
void loop_body(SceneEngine<dim, Real>& engine, int begin, int end) {
    constexpr Step step = What::plan.steps[static_cast<std::size_t>(k)];
    using Body = LoopBody<dim, Real, Scene, At<step.phase, typename Scene::Phases>>;
    using Nodes = NodesOfLoop<What, k>;
    if constexpr (step.sweep)
        Body::template sweep<Nodes>(engine, begin, end, typename SourcesOf<Nodes>::type{});
    else
        Body::run_on_particles(engine, begin, end, Nodes{});
}

} // namespace imbibe::detail
