// The composition of a scene, worked out at compile time: its nodes, the fields of each phase, the rows of the
// schedule, the plan, and the rules that they must keep.
#pragma once

#include <imbibe/solver/list_rules.hpp>
#include <imbibe/solver/nodes.hpp>
#include <imbibe/solver/passes.hpp>
#include <imbibe/solver/rules.hpp>
#include <imbibe/solver/schedule.hpp>

namespace imbibe {

/// @tparam dim 2 or 3
/// @tparam Items the phases and couplings of the scene
template <int dim, class... Items>
struct Composition {
    /// 2 or 3.
    static constexpr int dimension = dim;
    /// The phases and couplings as they were given.
    using All = TypeList<Items...>;
    /// The couplings listed.
    using Couplings = detail::Unique<detail::Filter<detail::KeepCouplings, All>>;
    /// The phases listed. A phase that a coupling names must be among them; if it is not, it is added, so that after
    /// the rule's one error everything else compiles.
    using Phases = detail::Unique<
        detail::Filter<detail::KeepPhases, detail::Concat<All, typename detail::PhasesNamed<Couplings>::type>>>;

    /// The parts of all terms, each on each phase it writes to.
    using Nodes = typename detail::CollectNodes<dim, Phases, Couplings>::type;
    /// The fields of a phase: all that a term reads, adds to, sets or stores, and no other.
    template <class P>
    using FieldsOf = typename detail::CollectFields<dim, P, Nodes>::type;

    /// The position of a phase in `Phases`.
    template <class P>
    static constexpr int phase_index = detail::index_of<P, Phases>;

    /// Does the phase keep its particles in the order of the stress-free configuration?
    template <class P>
    static constexpr bool keeps_reference = detail::contains<ReferencePosition, FieldsOf<P>>;

    /// @cond the columns and rows of the schedule: read schedule.hpp first
    /// The states a phase advances within the step: all that have a rate, but the velocity.
    template <class List>
    struct AdvancedStates;
    template <class... F>
    struct AdvancedStates<TypeList<F...>> {
        template <class G>
        using State =
            std::conditional_t<std::is_same_v<G, Rate<Velocity>>, TypeList<>, typename detail::StateOfRate<G>::type>;
        using type = detail::Concat<State<F>...>;
    };
    template <class P>
    using AdvancedOf = typename AdvancedStates<FieldsOf<P>>::type;

    /// The first column of each phase's fields in the schedule.
    template <class... P>
    static constexpr auto column_starts(TypeList<P...>) {
        std::array<int, sizeof...(P) + 1> start{};
        const int size[] = {FieldsOf<P>::size...};
        for (std::size_t k = 0; k < sizeof...(P); ++k)
            start[k + 1] = start[k] + size[k];
        return start;
    }
    static constexpr auto starts = column_starts(Phases{});

    template <class P, class F>
    static constexpr int column = starts[static_cast<std::size_t>(phase_index<P>)] + detail::index_of<F, FieldsOf<P>>;

    template <class P, class... F>
    static constexpr Bits columns(TypeList<F...>) {
        Bits bits;
        (bits.set(column<P, F>), ...);
        return bits;
    }
    template <class N>
    static constexpr Row row_of() {
        constexpr bool pair = detail::is_pair_node<dim, N>,
                       changes_density = !pair && detail::contains<Rate<Density>, typename N::Adds>,
                       changes_volume = requires { requires N::Term::changes_volume; };
        return {.reads = columns<typename N::A>(detail::ReadsOnA<dim, N>{}) |
                         columns<typename N::B>(detail::ReadsOnB<dim, N>{}),
                .adds = columns<typename N::A>(typename N::Adds{}),
                .sets = columns<typename N::A>(typename N::Sets{}),
                .phase = phase_index<typename N::A>,
                .pair = pair,
                .summed = changes_density && !changes_volume,
                .waits_for_all = changes_density && changes_volume};
    }
    template <class N>
    static constexpr bool declarations_fit =
        detail::check_all_read<typename N::Part, detail::reads_on<typename N::Part, dim, typename N::A, typename N::B>>(
            typename N::Reads{}) &&
        detail::check_returned<typename N::Part, dim, typename N::A, typename N::B>();

    template <class P, class F>
    using Advance = detail::Advance<P, F>;
    template <class N>
    static constexpr bool is_advance = detail::is_advance<N>;

    template <class P, class List>
    struct AdvancesOfPhase;
    template <class P, class... F>
    struct AdvancesOfPhase<P, TypeList<F...>> {
        using type = TypeList<Advance<P, F>...>;
    };
    template <class List>
    struct AllAdvances;
    template <class... P>
    struct AllAdvances<TypeList<P...>> {
        using type = detail::Concat<typename AdvancesOfPhase<P, AdvancedOf<P>>::type...>;
    };
    template <class P, class F>
    static constexpr Row advance_row(Advance<P, F>) {
        Row r{.phase = phase_index<P>, .advances = true, .waits_for_all = std::is_same_v<F, Density>};
        r.reads.set(column<P, Rate<F>>);
        r.sets.set(column<P, F>);
        return r;
    }
    template <class N>
    static constexpr Row any_row() {
        if constexpr (is_advance<N>)
            return advance_row(N{});
        else
            return row_of<N>();
    }

    template <class N>
    struct KeepOnce : std::bool_constant<N::once> {};
    template <class N>
    struct KeepEveryStep : std::bool_constant<!N::once> {};

    /// @endcond

    /// The rows of every step, and those that are evaluated once when the particles are added.
    using StepRows = detail::Concat<detail::Filter<KeepEveryStep, Nodes>, typename AllAdvances<Phases>::type>;
    /// The rows that are evaluated once.
    using OnceRows = detail::Filter<KeepOnce, Nodes>;

    /// @cond
    template <class... N>
    static constexpr auto rows(TypeList<N...>) {
        return std::array<Row, sizeof...(N)>{any_row<N>()...};
    }

    // What has a value before the plan runs: what the solver fills in, states that are integrated, and for the plan of
    // a step everything that is computed once.
    template <class P, class F>
    static constexpr bool integrated() {
        if constexpr (requires { F::rate_name; })
            return detail::contains<Rate<F>, FieldsOf<P>>;
        else
            return false;
    }
    template <class P, class... F>
    static constexpr Bits given_of_phase(TypeList<F...>) {
        Bits bits;
        ((F::given || integrated<P, F>() ? bits.set(column<P, F>) : void()), ...);
        return bits;
    }
    template <class... P>
    static constexpr Bits given_at_start(TypeList<P...>) {
        Bits bits;
        ((bits = bits | given_of_phase<P>(FieldsOf<P>{})), ...);
        return bits;
    }
    template <class... N>
    static constexpr Bits written_by(TypeList<N...>) {
        Bits bits;
        ((bits = bits | any_row<N>().adds | any_row<N>().sets), ...);
        return bits;
    }
    template <class... N>
    static constexpr Bits added_by(TypeList<N...>) {
        Bits bits;
        ((bits = bits | any_row<N>().adds), ...);
        return bits;
    }
    static constexpr Bits given = given_at_start(Phases{});
    // The order of some rows of a step, when those in `Before` have been evaluated.
    template <class Rows, class Before>
    static constexpr Plan plan_of(Rows, Before) {
        return schedule(rows(Rows{}), given | written_by(OnceRows{}) | written_by(Before{}));
    }
    /// @endcond
    /// The order of the rows that are evaluated once.
    static constexpr Plan once_plan = schedule(rows(OnceRows{}), given);
    /// The order of the rows of a step.
    static constexpr Plan plan = plan_of(StepRows{}, TypeList<>{});

    // ---- what an integrator can ask for, a pass: rows, the plan that orders them, what they add to ----
    // `gravity`: does the acceleration of all phases start from gravity, or is something in it already?

    /// What is computed once, when the particles are there.
    struct Once {
        using Rows = OnceRows;
        static constexpr Plan plan = once_plan;
        static constexpr Bits added = added_by(Rows{});
        static constexpr bool gravity = false;
    };
    /// All terms; states advance as soon as their rates are there, and forces see the new ones.
    struct WholeStep {
        using Rows = StepRows;
        static constexpr Plan plan = Composition::plan;
        static constexpr Bits added = added_by(Rows{});
        static constexpr bool gravity = true;
    };
    /// All terms, with the states as they are: rates and forces of one moment, in as few sweeps as they need.
    struct Rates {
        using Rows = detail::Filter<KeepEveryStep, Nodes>;
        static constexpr Plan plan = plan_of(Rows{}, TypeList<>{});
        static constexpr Bits added = added_by(Rows{});
        static constexpr bool gravity = true;
    };
    /// What the rates of states are made of; the states advance at its end.
    using States = detail::States<Composition>;
    /// All other terms: forces, with the states as they are.
    using Forces = detail::Forces<Composition>;
    /// The terms of phase P itself, which act on top of what couplings have put into its acceleration.
    template <class P>
    using OwnTerms = detail::OwnTerms<Composition, P>;
    /// All other terms: those of the other phases and all couplings.
    template <class P>
    using AllButOwnTerms = detail::AllButOwnTerms<Composition, P>;
    /// The terms in a `TypeList`, with what only they ask for, with the states as they are.
    template <class List>
    using TermsOf = detail::TermsOf<Composition, List>;
    /// All other terms, which act on top of what those in the list have put into accelerations; states advance.
    template <class List>
    using AllButTermsOf = detail::AllButTermsOf<Composition, List>;

    // ---- the rules ----
    /// @cond
    template <int c, class... P>
    static constexpr auto field_at_column(TypeList<P...>) {
        return field_in<c, 0, P...>();
    }
    template <int c, int k, class P, class... Rest>
    static constexpr auto field_in() {
        constexpr int here = c - starts[static_cast<std::size_t>(k)];
        if constexpr (here < FieldsOf<P>::size)
            return detail::At<here, FieldsOf<P>>{};
        else
            return field_in<c, k + 1, Rest...>();
    }
    template <bool once>
    static constexpr bool check_plan() {
        using Rows = std::conditional_t<once, OnceRows, StepRows>;
        constexpr Fault fault = (once ? once_plan : plan).fault;
        constexpr int column_at_fault = (once ? once_plan : plan).column;
        constexpr int row = (once ? once_plan : plan).row;
        constexpr int other = (once ? once_plan : plan).other < 0 ? row : (once ? once_plan : plan).other;
        if constexpr (fault == Fault::nobody_sets) {
            using N = detail::At<row, Rows>;
            using F = decltype(field_at_column<column_at_fault>(Phases{}));
            using P = detail::At<phase_of_column(column_at_fault), Phases>;
            using Equation = std::conditional_t<P::moves, add_an_equation_of_state_such_as_Tait,
                                                add_PressureExtrapolation_to_the_coupling_Into_the_wall>;
            using Advice = std::conditional_t<std::is_same_v<F, Pressure>, Equation, add_a_term_that_sets_it>;
            return detail::break_rule<rules::NobodySets<F, typename N::Term, P, Advice>>();
        } else if constexpr (fault == Fault::set_twice) {
            using N = detail::At<row, Rows>;
            using M = detail::At<other, Rows>;
            using F = decltype(field_at_column<column_at_fault>(Phases{}));
            return detail::break_rule<
                rules::SetTwice<F, WriterOf<N>, WriterOf<M>, typename N::A, remove_one_of_the_two_terms>>();
        } else if constexpr (fault == Fault::cycle) {
            using N = detail::At<row, Rows>;
            using M = detail::At<other, Rows>;
            return detail::break_rule<
                rules::Cycle<typename N::Term, typename M::Term, make_one_of_the_two_terms_read_something_else>>();
        } else if constexpr (fault == Fault::too_large || (!once && starts[Phases::size] > Bits::capacity)) {
            return detail::break_rule<
                rules::TooLarge<std::bool_constant<once>, use_fewer_terms_or_raise_the_limits_in_schedule_hpp>>();
        } else {
            return true;
        }
    }
    // The term that a row belongs to; for a row that advances a state, the first term that adds to its rate.
    template <class N, class... M>
    static constexpr auto writer_of(TypeList<M...>) {
        if constexpr (!is_advance<N>) {
            return std::type_identity<typename N::Term>{};
        } else {
            constexpr bool adds[] = {adds_to_rate<N, M>()...};
            constexpr int first = [&] {
                int k = 0;
                while (!adds[k])
                    ++k;
                return k;
            }();
            return std::type_identity<typename detail::At<first, TypeList<M...>>::Term>{};
        }
    }
    template <class N, class M>
    static constexpr bool adds_to_rate() {
        return std::is_same_v<typename N::A, typename M::A> &&
               detail::contains<Rate<typename N::Field>, typename M::Adds>;
    }
    template <class N>
    using WriterOf = typename decltype(writer_of<N>(Nodes{}))::type;

    static constexpr int phase_of_column(int c) {
        int k = 0;
        while (c >= starts[static_cast<std::size_t>(k + 1)])
            ++k;
        return k;
    }
    template <class... N>
    static constexpr bool all_declarations_fit(TypeList<N...>) {
        return (declarations_fit<N> && ...) && (check_pair_part<N>() && ...) &&
               (check_sums<N>(typename N::Adds{}) && ...);
    }
    template <class N, class... F>
    static constexpr bool check_sums(TypeList<F...>) {
        return (check_sum<N, F>() && ...);
    }
    template <class N, class F>
    static constexpr bool check_sum() {
        if constexpr (F::given || integrated<typename N::A, F>())
            return detail::break_rule<
                rules::AddsToAState<F, typename N::Term, typename N::A, let_the_part_add_to_its_rate_or_set_it>>();
        else
            return true;
    }
    template <class N>
    static constexpr bool check_pair_part() {
        if constexpr (detail::is_pair_node<dim, N> && N::Sets::size > 0)
            return detail::break_rule<
                rules::PairPartSets<typename N::Part, typename N::Term, let_the_part_add_to_the_field>>();
        else
            return true;
    }
    template <class N>
    static constexpr bool check_neighbourhood() {
        if constexpr (N::reference && !std::is_same_v<typename N::A, typename N::B>)
            return detail::break_rule<rules::ReferenceNeighboursInCoupling<
                typename N::Term, typename N::Owner, give_the_term_to_the_phase_or_use_current_neighbours>>();
        else if constexpr (N::reference && !std::is_void_v<typename N::Reach>)
            return detail::break_rule<rules::OwnSupportOfReferenceNeighbours<
                typename N::Term, typename N::Owner, remove_its_support_radius_or_use_current_neighbours>>();
        else if constexpr (detail::support_of_another_form<typename N::Term, typename N::Owner>)
            return detail::break_rule<rules::SupportRadiusNotUsable<
                typename N::Term, typename N::Owner, write_static_double_support_radius_of_a_material_or_of_two>>();
        else
            return true;
    }
    template <class... N>
    static constexpr bool check_neighbourhoods(TypeList<N...>) {
        return (check_neighbourhood<N>() && ...);
    }
    /// @endcond
    /// @cond
    static constexpr bool check_once() {
        constexpr Bits twice = written_by(OnceRows{}) & written_by(detail::Filter<KeepEveryStep, Nodes>{});
        if constexpr (twice.any()) {
            constexpr int column = [&] {
                int k = 0;
                while (!twice.test(k))
                    ++k;
                return k;
            }();
            using F = decltype(field_at_column<column>(Phases{}));
            using P = detail::At<phase_of_column(column), Phases>;
            return detail::break_rule<rules::OnceAndInEveryStep<F, P, remove_one_of_the_two_terms>>();
        } else {
            return true;
        }
    }
    // The rules one by one: errors that follow from a broken rule are not reported.
    static constexpr bool check() {
        if constexpr (detail::ListRules<Items...>::check())
            if constexpr (all_declarations_fit(Nodes{}))
                if constexpr (check_neighbourhoods(Nodes{}) && check_once())
                    return check_plan<true>() && check_plan<false>();
        return false;
    }
    /// @endcond
    /// True, or a compile error that names the broken rule.
    static constexpr bool valid = check();
};

namespace detail {

// A stand-in for the engine of a scene, where only the name of a step is needed.
struct AnyEngine;
template <class Given>
concept IsIntegrator = requires {
    &Given::template step<AnyEngine>;
};

template <class Real>
inline constexpr bool is_real = std::is_same_v<Real, float> || std::is_same_v<Real, double>;

/// Takes no steps: replaces an argument that is no integrator, so that there is one error only.
struct NoSteps {
    template <class Engine>
    static void step(Engine&, double) {}
};
/// The composition of a solver's arguments. If they are wrong, a phase or coupling given in the place of another counts
/// as listed.
template <int dim, class Real, class Integrator, class... Items>
struct SceneOf {
    template <class... All>
    static Composition<dim, All...> of(TypeList<All...>);
    template <class T>
    struct Keep : std::bool_constant<IsPhase<T> || IsCoupling<T>> {};
    using type = decltype(of(Unique<Concat<Filter<Keep, TypeList<Real, Integrator>>, TypeList<Items...>>>{}));
};
template <int dim, class Real, IsIntegrator Integrator, class... Items>
requires is_real<Real>
struct SceneOf<dim, Real, Integrator, Items...> {
    using type = Composition<dim, Items...>;
};

/// True, or a compile error that names the broken rule: are the arguments of a solver what they should be, and does the
/// scene keep its rules? One after the other, as above.
template <int dim, class Real, class Integrator, class... Items>
constexpr bool check_scene() {
    if constexpr (!check_dimension<dim>())
        return false;
    else if constexpr (!is_real<Real>)
        return break_rule<rules::NotRealNumbers<Real, write_float_or_double>>();
    else if constexpr (IsPhase<Integrator> || IsCoupling<Integrator>)
        return break_rule<
            rules::NoIntegrator<Integrator, put_an_integrator_such_as_SymplecticEuler_before_the_phases>>();
    else if constexpr (!IsIntegrator<Integrator>)
        return break_rule<rules::NotAnIntegrator<Integrator, give_it_one_such_as_SymplecticEuler>>();
    else
        return Composition<dim, Items...>::valid;
}

} // namespace detail

} // namespace imbibe
