// Parts of a step, for integrators that do not evaluate all terms at once, or some more often than others. A pass is
// what an engine runs: rows of the schedule, the plan that orders them, the columns they add to, which start from zero,
// and `gravity`: does the acceleration of all phases start from gravity, or from existing values? A pass that runs
// several times has columns that are `kept`: they start each time from the result of another pass, which runs once.
#pragma once

#include <imbibe/solver/nodes.hpp>
#include <imbibe/solver/rules.hpp>
#include <imbibe/solver/schedule.hpp>

namespace imbibe::detail {

/// The rows that are not in `some`, with all rows that write what they read.
template <std::size_t n>
constexpr Bits all_but(const Bits& some, const std::array<Row, n>& rows) {
    Bits chosen;
    for (int k = 0; k < static_cast<int>(n); ++k)
        if (!some.test(k))
            chosen.set(k);
    return with_what_they_read(rows, chosen);
}

/// The chosen ones of `rows` with all rows that write what they read, and all that add to the sums that they add to,
/// except the columns `partial`: out of `all`, the same rows, none of them left empty.
template <std::size_t n>
constexpr Bits with_whole_sums(std::array<Row, n> rows, const std::array<Row, n>& all, Bits chosen,
                               const Bits& partial) {
    for (Bits before; before != chosen;) {
        chosen = with_what_they_read(rows, chosen);
        before = chosen;
        Bits summed;
        for (std::size_t k = 0; k < n; ++k)
            if (chosen.test(static_cast<int>(k)))
                summed = summed | (rows[k].adds - partial);
        for (std::size_t k = 0; k < n; ++k)
            if ((all[k].adds & summed).any()) {
                rows[k] = all[k];
                chosen.set(static_cast<int>(k));
            }
    }
    return chosen;
}

/// The rows of a step that advance states, with all rows that their rates depend on; and all others, with the rows they
/// need.
template <class Scene>
class RowsForStates {
    static constexpr Bits find_states() {
        const auto rows = Scene::rows(typename Scene::StepRows{});
        Bits chosen;
        for (std::size_t k = 0; k < rows.size(); ++k)
            if (rows[k].advances)
                chosen.set(static_cast<int>(k));
        return with_what_they_read(rows, chosen);
    }
    static constexpr Bits states = find_states();
    static constexpr Bits forces = all_but(states, Scene::rows(typename Scene::StepRows{}));
    template <class N>
    struct IsForStates : std::bool_constant<states.test(index_of<N, typename Scene::StepRows>)> {};
    template <class N>
    struct IsForForces : std::bool_constant<forces.test(index_of<N, typename Scene::StepRows>)> {};

public:
    using States = Filter<IsForStates, typename Scene::StepRows>;
    using Forces = Filter<IsForForces, typename Scene::StepRows>;
};

/// The rows that the rates of states depend on; the states advance at its end.
template <class Scene>
struct States {
    using Rows = typename RowsForStates<Scene>::States;
    static constexpr Plan plan = Scene::plan_of(Rows{}, TypeList<>{});
    static constexpr Bits added = Scene::added_by(Rows{});
    static constexpr bool gravity = false;
};

/// All other terms: forces, with unchanged states.
template <class Scene>
struct Forces {
    using Rows = typename RowsForStates<Scene>::Forces;
    static constexpr Plan plan = Scene::plan_of(Rows{}, TypeList<>{});
    static constexpr Bits added = Scene::added_by(Rows{});
    static constexpr bool gravity = true;
};

/// The rows of phase P's own terms and of its states, and those of all others.
template <class Scene, class P>
class RowsOfPhase {
    template <class N>
    static constexpr bool is_own() {
        if constexpr (is_advance<N>)
            return std::is_same_v<typename N::A, P>;
        else
            return std::is_same_v<typename N::Owner, P>;
    }
    template <class N>
    struct IsOwn : std::bool_constant<is_own<N>()> {};
    template <class N>
    struct IsOther : std::bool_constant<!is_own<N>()> {};

public:
    using Own = Filter<IsOwn, typename Scene::StepRows>;
    using Others = Filter<IsOther, typename Scene::StepRows>;
};

/// The terms of phase P itself, added to what couplings have put into its acceleration and its other sums.
template <class Scene, class P>
struct OwnTerms {
    using Rows = typename RowsOfPhase<Scene, P>::Own;
    static constexpr Plan plan = Scene::plan_of(Rows{}, typename RowsOfPhase<Scene, P>::Others{});
    static constexpr Bits kept = Scene::template columns<P>(TypeList<Rate<Velocity>>{}) |
                                 (Scene::added_by(Rows{}) & Scene::added_by(typename RowsOfPhase<Scene, P>::Others{}));
    static constexpr Bits added = Scene::added_by(Rows{}) - kept;
    static constexpr bool gravity = false;
};

/// All other terms: those of the other phases and all couplings.
template <class Scene, class P>
struct AllButOwnTerms {
    using Rows = typename RowsOfPhase<Scene, P>::Others;
    static constexpr Plan plan = Scene::plan_of(Rows{}, typename RowsOfPhase<Scene, P>::Own{});
    static constexpr Bits added = Scene::added_by(Rows{});
    static constexpr bool gravity = true;
};

/// The rows of the terms in a list, and those of all others. A function of a particle that both need, such as Volume,
/// belongs to the others; what only the list's terms read belongs to the list.
template <class Scene, class List>
class RowsOfTerms {
    template <class Part, class... T>
    static constexpr bool is_part_of_another(TypeList<T...>) {
        return ((!contains<typename Listed<T>::Term, List> && contains<Part, PartList<typename Listed<T>::Term>>) ||
                ...);
    }
    template <class Part, class... Item>
    static constexpr bool is_shared(TypeList<Item...>) {
        return (is_part_of_another<Part>(typename Item::terms{}) || ...);
    }
    template <class N>
    static constexpr bool is_listed() {
        if constexpr (is_advance<N>)
            return false;
        else
            return contains<typename N::Term, List> &&
                   (is_pair_node<Scene::dimension, N> || !is_shared<typename N::Part>(typename Scene::All{}));
    }
    // The rows of a step; listed ones are empty, so that none is found by what it writes.
    template <class... N>
    static constexpr auto rows_of_others(TypeList<N...>) {
        return std::array<Row, sizeof...(N)>{(is_listed<N>() ? Row{} : Scene::template any_row<N>())...};
    }
    template <class T, class... Item>
    static constexpr bool check_one(TypeList<Item...>) {
        if constexpr (!(lists<T>(typename Item::terms{}) || ...))
            return break_rule<rules::TermNotInTheScene<T, list_it_in_a_phase_or_coupling_or_do_not_name_it>>();
        else
            return true;
    }
    template <class T, class... Term>
    static constexpr bool lists(TypeList<Term...>) {
        return (std::is_same_v<T, typename Listed<Term>::Term> || ...);
    }
    template <class... T>
    static constexpr bool check_all(TypeList<T...>) {
        return (check_one<T>(typename Scene::All{}) && ...);
    }
    template <class N, class... F>
    static constexpr bool check_sums(TypeList<F...>) {
        return (check_sum<N>(typename StateOfRate<F>::type{}) && ...);
    }
    template <class N>
    static constexpr bool check_sum(TypeList<>) {
        return true;
    }
    template <class N, class F>
    static constexpr bool check_sum(TypeList<F>) {
        if constexpr (!std::is_same_v<F, Velocity>)
            return break_rule<rules::SlowTermOfState<F, typename N::Term, let_every_short_step_evaluate_it>>();
        else
            return true;
    }
    // A term of the list may set a helper field for others (a volume), but no state, which would lag behind the
    // particles.
    template <class N, class... F>
    static constexpr bool check_set(TypeList<F...>) {
        if constexpr ((F::given || ...))
            return break_rule<
                rules::SlowTermOfState<TypeList<F...>, typename N::Term, let_every_short_step_evaluate_it>>();
        else
            return true;
    }
    template <class N>
    static constexpr bool check_row() {
        if constexpr (is_listed<N>())
            return check_sums<N>(typename N::Adds{}) && check_set<N>(typename N::Sets{});
        else
            return true;
    }
    template <class... N>
    static constexpr bool check_rows(TypeList<N...>) {
        return (check_row<N>() && ...);
    }
    // A field of all phases that have it.
    template <class F, class P>
    static constexpr Bits column_of() {
        if constexpr (contains<F, typename Scene::template FieldsOf<P>>)
            return Scene::template columns<P>(TypeList<F>{});
        else
            return {};
    }
    template <class F, class... P>
    static constexpr Bits columns_of(TypeList<P...>) {
        return (Bits{} | ... | column_of<F, P>());
    }
    // The others are the rows that move particles or advance their states, and all rows these depend on. A sum other
    // than of accelerations must be complete with them, so it includes rows of the list that add to it.
    static constexpr Bits find_others() {
        constexpr auto rows = rows_of_others(typename Scene::StepRows{});
        constexpr Bits motion = columns_of<Rate<Velocity>>(typename Scene::Phases{}) |
                                columns_of<Velocity>(typename Scene::Phases{}) |
                                columns_of<TransportCorrection>(typename Scene::Phases{});
        Bits chosen;
        for (std::size_t k = 0; k < rows.size(); ++k)
            if (rows[k].advances || ((rows[k].adds | rows[k].sets) & motion).any())
                chosen.set(static_cast<int>(k));
        constexpr Bits partial = columns_of<Rate<Velocity>>(typename Scene::Phases{}); // g++ 12: not by accelerations()
        return with_whole_sums(rows, Scene::rows(typename Scene::StepRows{}), chosen, partial);
    }
    static constexpr Bits others = find_others();
    static constexpr Bits listed = all_but(others, Scene::rows(typename Scene::StepRows{}));
    template <class N>
    struct IsListed : std::bool_constant<listed.test(index_of<N, typename Scene::StepRows>)> {};
    template <class N>
    struct IsOther : std::bool_constant<others.test(index_of<N, typename Scene::StepRows>)> {};

public:
    using Own = Filter<IsListed, typename Scene::StepRows>;
    using Others = Filter<IsOther, typename Scene::StepRows>;
    /// True, or a compile error: are the terms of the list in the scene, and can they be evaluated separately?
    static constexpr bool check() { return check_all(List{}) && check_rows(typename Scene::StepRows{}); }
    /// The acceleration of every phase that moves.
    static constexpr Bits accelerations() { return columns_of<Rate<Velocity>>(typename Scene::Phases{}); }
};

/// The terms in a list, with what only they need, with unchanged states.
template <class Scene, class List>
struct TermsOf {
    using Rows = typename RowsOfTerms<Scene, List>::Own;
    static constexpr Plan plan = Scene::plan_of(Rows{}, TypeList<>{});
    static constexpr Bits added = Scene::added_by(Rows{});
    static constexpr bool gravity = true;
};

/// All other terms, added to what those in the list have put into accelerations; states advance.
template <class Scene, class List>
struct AllButTermsOf {
    using Rows = typename RowsOfTerms<Scene, List>::Others;
    static constexpr Plan plan = Scene::plan_of(Rows{}, typename RowsOfTerms<Scene, List>::Own{});
    static constexpr Bits kept = RowsOfTerms<Scene, List>::accelerations();
    static constexpr Bits added = Scene::added_by(Rows{}) - kept;
    static constexpr bool gravity = false;
};

} // namespace imbibe::detail
