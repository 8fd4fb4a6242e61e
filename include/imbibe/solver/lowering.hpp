// Makes the tables of a scene (tables.hpp) from its composition: types become data.
#pragma once

#include <imbibe/core/phase.hpp>
#include <imbibe/solver/composition.hpp>
#include <imbibe/solver/loop_bodies.hpp>
#include <imbibe/solver/reductions.hpp>

namespace imbibe::detail {

/// The first column of a field, or -1 where it is not in the list.
template <int dim, class F, class List>
constexpr int column_or_none() {
    if constexpr (contains<F, List>)
        return component_offset<dim, F, List>;
    else
        return -1;
}

/// A default object of a type, with its type erased.
template <class T>
std::any any_of() {
    return T{};
}

/// The row of a phase.
template <int dim, class Scene, class P>
class IMBIBE_PER_BUILD PhaseRowOf {
    using Fields = typename Scene::template FieldsOf<P>;
    template <class... F>
    static constexpr std::array<FieldRow, sizeof...(F)> field_rows(TypeList<F...>) {
        return {FieldRow{F::name, F::unit, F::rank, F::given || Scene::template integrated<P, F>() || F::shown,
                         component_offset<dim, F, Fields>, components(F::rank, dim),
                         F::given || Scene::template integrated<P, F>()}...};
    }
    template <class... F>
    static constexpr std::array<StateRow, sizeof...(F)> state_rows(TypeList<F...>) {
        return {StateRow{component_offset<dim, F, Fields>, component_offset<dim, Rate<F>, Fields>,
                         components(F::rank, dim), std::is_same_v<F, Density>}...};
    }
    static constexpr auto fields = field_rows(Fields{});
    static constexpr auto states = state_rows(typename Scene::template AdvancedOf<P>{});

    static std::string name() { return name_among<P>(typename Scene::Phases{}); }
    static PhaseNumbers numbers(const std::any& material) {
        const P& m = *std::any_cast<P>(&material);
        PhaseNumbers all{.support_radius = m.support_radius, .spacing = m.spacing, .density = m.density};
        if constexpr (P::moves)
            all.sound_speed = m.sound_speed;
        return all;
    }
    template <class F>
    static constexpr int column = column_or_none<dim, F, Fields>();

public:
    static constexpr PhaseRow row{.name = &name,
                                  .fields = fields,
                                  .states = states,
                                  .components = component_count<dim, Fields>,
                                  .first_bit = Scene::starts[static_cast<std::size_t>(Scene::template phase_index<P>)],
                                  .moves = P::moves,
                                  .drifts = drifts<P>,
                                  .fluid = is_fluid<P>,
                                  .position = column<Position>,
                                  .reference_position = column<ReferencePosition>,
                                  .velocity = column<Velocity>,
                                  .acceleration = column<Rate<Velocity>>,
                                  .mass = column<Mass>,
                                  .density = column<Density>,
                                  .density_rate = column<Rate<Density>>,
                                  .mobility = column<Mobility>,
                                  .transport_correction = column<TransportCorrection>,
                                  .supported_share = column<SupportedShare>,
                                  .implicit_acceleration = column<ImplicitAcceleration>,
                                  .porosity = column<Porosity>,
                                  .material = &any_of<P>,
                                  .numbers = &numbers};
};

/// The tables of a scene. @tparam Scene a Composition
template <int dim, class Real, class Scene>
class IMBIBE_PER_BUILD Lowering {
    using Phases = typename Scene::Phases;
    using Couplings = typename Scene::Couplings;
    template <class P>
    static constexpr int index = Scene::template phase_index<P>;

    template <class... P>
    static constexpr std::array<PhaseRow, sizeof...(P)> phase_rows(TypeList<P...>) {
        return {PhaseRowOf<dim, Scene, P>::row...};
    }
    // Is phase P a fluid that coupling C pushes by pressure, and whose density, which follows from its motion, does not
    // count the other phase? A repulsion is fine: it rises by itself.
    template <class C, class P>
    static constexpr bool
        counts_no_other = is_fluid<P>&& has_effect_on<P, effects::continuity_equation>(typename P::terms{}) &&
                          has_effect_on<P, effects::pressure_force>(typename C::terms{}) &&
                          !has_effect_on<P, effects::continuity_equation>(typename C::terms{}) &&
                          !asks_for_nearest(typename C::terms{});
    template <class C>
    static std::string name_of_coupling() {
        return name_among<C>(Couplings{});
    }
    template <class... C>
    static constexpr std::array<CouplingRow, sizeof...(C)> coupling_rows(TypeList<C...>) {
        return {CouplingRow{.name = &name_of_coupling<C>,
                            .first = index<typename C::First>,
                            .second = index<typename C::Second>,
                            .overlaps = overlaps(typename C::terms{}),
                            .asks_for_nearest = asks_for_nearest(typename C::terms{}),
                            .first_counts_no_second = counts_no_other<C, typename C::First>,
                            .second_counts_no_first = counts_no_other<C, typename C::Second>,
                            .coupling = &any_of<C>}...};
    }
    template <class Owner, class Term>
    static double support_of(const std::any& owner, const std::any& first, const std::any& second) {
        const Owner& of = *std::any_cast<Owner>(&owner);
        if constexpr (IsCoupling<Owner>)
            return support_of_term<Term>(of, *std::any_cast<typename Owner::First>(&first),
                                         *std::any_cast<typename Owner::Second>(&second));
        else
            return support_of_term<Term>(of, of);
    }
    template <class L>
    static constexpr LinkRow link_row() {
        LinkRow row{.a = index<typename L::A>, .b = index<typename L::B>, .reference = L::reference};
        if constexpr (!std::is_void_v<typename L::Reach>) {
            using Owner = typename L::Reach::Owner;
            using Term = typename L::Reach::Term;
            if constexpr (IsCoupling<Owner>)
                row.coupling = index_of<Owner, Couplings>;
            row.term = &type_name<Term>;
            row.support_of_term = &support_of<Owner, Term>;
        }
        return row;
    }
    template <class... L>
    static constexpr std::array<LinkRow, sizeof...(L)> link_rows(TypeList<L...>) {
        return {link_row<L>()...};
    }

public:
    /// Which phases have neighbours in which.
    using Links = typename LinksOf<dim, typename Scene::Nodes>::type;

private:
    static constexpr auto phases = phase_rows(Phases{});
    static constexpr auto couplings = coupling_rows(Couplings{});
    static constexpr auto links = link_rows(Links{});

    template <class... N>
    static constexpr std::array<Reduction<dim, Real>, sizeof...(N)> reduction_rows(TypeList<N...>) {
        return {reduction_of<N, typename Scene::template FieldsOf<typename N::A>, dim, Real>(index<typename N::A>)...};
    }
    static constexpr auto reduction_array = reduction_rows(typename CollectReductions<Phases>::type{});

    template <class P, class... S>
    static constexpr std::array<int, sizeof...(S)> links_of(TypeList<S...>) {
        return {index_of<LinkType<P, typename S::B, S::reference, typename S::Reach>, Links>...};
    }
    template <class What, int k>
    class LoopOf {
        static constexpr Step step = What::plan.steps[static_cast<std::size_t>(k)];
        using P = At<step.phase, Phases>;
        static constexpr auto links_of_sweep() {
            if constexpr (step.sweep)
                return links_of<P>(typename SourcesOf<NodesOfLoop<What, k>>::type{});
            else
                return std::array<int, 0>{};
        }
        static constexpr auto swept = links_of_sweep();
        template <class N>
        static constexpr void note(Loop<dim, Real>& made) {
            using A = typename N::A;
            if constexpr (is_advance<N>) {
                using F = typename N::Field;
                made.reads_own = made.reads_own | Scene::template columns<A>(TypeList<F, Rate<F>>{});
                made.writes = made.writes | Scene::template columns<A>(TypeList<F>{});
                made.advances_density = made.advances_density || std::is_same_v<F, Density>;
            } else {
                made.reads_own = made.reads_own | Scene::template columns<A>(ReadsOnA<dim, N>{});
                if constexpr (is_pair_node<dim, N>) {
                    using B = typename N::B;
                    using Place = std::conditional_t<N::reference, ReferencePosition, Position>;
                    made.reads_own = made.reads_own | Scene::template columns<A>(TypeList<Place>{});
                    made.reads_near = made.reads_near | Scene::template columns<B>(ReadsOnB<dim, N>{}) |
                                      Scene::template columns<B>(TypeList<Place>{});
                }
                made.writes = made.writes | Scene::template columns<A>(Concat<typename N::Adds, typename N::Sets>{});
            }
        }

    public:
        static constexpr Loop<dim, Real> loop = [] {
            Loop<dim, Real> made{.sweep = step.sweep,
                                 .phase = step.phase,
                                 .links = swept,
                                 .body = &loop_body<dim, Real, Scene, What, k>};
            [&]<class... N>(TypeList<N...>) { (note<N>(made), ...); }(NodesOfLoop<What, k>{});
            return made;
        }();
    };
    template <class What, std::size_t... k>
    static constexpr std::array<Loop<dim, Real>, sizeof...(k)> loops_of(std::index_sequence<k...>) {
        return {LoopOf<What, static_cast<int>(k)>::loop...};
    }

    // The fields of all phases that are chosen, as columns. @param chosen (row, its bit) says whether, and how
    template <class Chosen>
    static constexpr int count_columns(const Chosen& chosen) {
        int count = 0;
        for (const PhaseRow& phase : phases)
            for (std::size_t k = 0; k < phase.fields.size(); ++k)
                count += chosen(phase, static_cast<int>(k));
        return count;
    }
    template <int count, class Chosen>
    static constexpr auto list_columns(const Chosen& chosen, bool gravity) {
        std::array<ColumnRange, static_cast<std::size_t>(count)> all{};
        std::size_t at = 0;
        for (std::size_t p = 0; p < phases.size(); ++p)
            for (std::size_t k = 0; k < phases[p].fields.size(); ++k)
                if (chosen(phases[p], static_cast<int>(k))) {
                    const FieldRow& field = phases[p].fields[k];
                    all[at++] = {static_cast<int>(p), field.first, field.components,
                                 gravity && field.first == phases[p].acceleration};
                }
        return all;
    }
    template <class What>
    class PassOf {
        static constexpr auto loops =
            loops_of<What>(std::make_index_sequence<static_cast<std::size_t>(What::plan.size)>{});
        static constexpr bool is_cleared(const PhaseRow& phase, int k) {
            return What::added.test(phase.first_bit + k) ||
                   (What::gravity && phase.fields[static_cast<std::size_t>(k)].first == phase.acceleration);
        }
        static constexpr bool is_kept(const PhaseRow& phase, int k) {
            if constexpr (requires { What::kept; })
                return What::kept.test(phase.first_bit + k);
            else
                return false;
        }
        static constexpr auto cleared = list_columns<count_columns(is_cleared)>(is_cleared, What::gravity);
        static constexpr auto kept = list_columns<count_columns(is_kept)>(is_kept, false);

    public:
        static constexpr Pass<dim, Real> pass{.loops = loops, .cleared = cleared, .kept = kept};
    };

public:
    /// The scene's phases, couplings and links.
    static constexpr SceneTable scene{.phases = phases, .couplings = couplings, .links = links};
    /// The reductions of its terms.
    static constexpr std::span<const Reduction<dim, Real>> reductions = reduction_array;
    /// One of its passes. @tparam What a pass of the composition
    template <class What>
    static constexpr const Pass<dim, Real>& pass() {
        return PassOf<What>::pass;
    }
};

} // namespace imbibe::detail
