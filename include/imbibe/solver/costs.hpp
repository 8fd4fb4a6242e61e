// The costs of a composition as constants: numbers stored, rounds, loops and sweeps, and what a sweep loads. Known at
// compile time, so a program can assert that an effect it does not list costs nothing.
#pragma once

#include <imbibe/solver/solver.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace imbibe {

namespace detail {

/// The passes of a step: those of the integrator, or all terms at once.
template <class Integrator, class Composition>
struct PassesOf {
    using type = TypeList<typename Composition::WholeStep>;
};
template <class Integrator, class Composition>
requires requires {
    typename Integrator::template Passes<Composition>;
}
struct PassesOf<Integrator, Composition> {
    using type = typename Integrator::template Passes<Composition>;
};

/// The loads of the sweeps of a pass in a composition in `dim` dimensions.
template <int dim, class Pass>
class PassLoads {
    template <class L, class N>
    static constexpr bool meets =
        std::is_same_v<LinkType<typename N::A, typename N::B, N::reference, typename N::Reach>, L>;
    // Of one sweep.
    template <class L, class... N>
    static constexpr int loads_of() {
        using Place = std::conditional_t<L::reference, ReferencePosition, Position>;
        using Read = Unique<Concat<TypeList<Place>, std::conditional_t<meets<L, N>, ReadsOnB<dim, N>, TypeList<>>...>>;
        return (meets<L, N> || ...) ? component_count<dim, Read> : 0;
    }
    template <class L, std::size_t k, std::size_t... r>
    static constexpr int loads_of_rows(std::index_sequence<r...>) {
        return loads_of<L, At<Pass::plan.steps[k].rows[r], typename Pass::Rows>...>();
    }
    template <class L, std::size_t k>
    static constexpr int loads_of_step() {
        constexpr Step step = Pass::plan.steps[k];
        if constexpr (step.sweep)
            return loads_of_rows<L, k>(std::make_index_sequence<static_cast<std::size_t>(step.size)>{});
        else
            return 0;
    }
    template <class L, std::size_t... k>
    static constexpr int loads_of_steps(std::index_sequence<k...>) {
        return (loads_of_step<L, k>() + ... + 0);
    }

public:
    /// How many numbers are loaded for a particle and one of its neighbours in the link.
    template <class L>
    static constexpr int
        loads = loads_of_steps<L>(std::make_index_sequence<static_cast<std::size_t>(Pass::plan.size)>{});
};

/// The subject of the costs: a composition, evaluated as a whole, or a scene with an integrator.
template <class Scene>
struct Costed;
template <int dim_, class... Items>
struct Costed<Composition<dim_, Items...>> {
    static constexpr int dim = dim_;
    using Scene = Composition<dim, Items...>;
    using Passes = TypeList<typename Scene::WholeStep>;
};
template <int dim_, class Real, class Integrator, class... Items>
struct Costed<Solver<dim_, Real, Integrator, Items...>> {
    // After an error about its arguments a solver uses others.
    using Whole = Solver<dim_, Real, Integrator, Items...>;
    static constexpr int dim = Whole::dimension;
    using Scene = typename Whole::Scene;
    using Passes = typename PassesOf<typename Whole::Integrator, Scene>::type;
};

} // namespace detail

/// The costs of a scene in one step with a search.
/// @tparam Scene_ a `Solver`: with the evaluations of its integrator in a step (for a fast phase of `Subcycled`, in one
/// of its own steps; for the fast terms of `DualStepping`, in one short step); or a composition, `Solver::Scene`: with
/// one evaluation of all of its terms, as SymplecticEuler makes
template <class Scene_>
class Costs {
    using Scene = typename detail::Costed<Scene_>::Scene;
    static constexpr int dim = detail::Costed<Scene_>::dim;
    template <class F>
    static constexpr int sum(F of_pass) {
        return [of_pass]<class... Pass>(TypeList<Pass...>) {
            return (of_pass(std::type_identity<Pass>{}) + ...);
        }(typename detail::Costed<Scene_>::Passes{});
    }

    template <class P, class B, class... L>
    static constexpr int loads_between(TypeList<L...>) {
        return ((std::is_same_v<typename L::A, P> && std::is_same_v<typename L::B, B> ? loads_of_link<L> : 0) + ... +
                0);
    }

public:
    /// How many numbers a particle of phase P stores.
    template <class P>
    static constexpr int numbers = detail::component_count<dim, typename Scene::template FieldsOf<P>>;
    /// The bytes of these numbers. A scene also stores an id for each particle and, for sorting, everything twice.
    template <class P, class Real>
    static constexpr std::size_t bytes = static_cast<std::size_t>(numbers<P>) * sizeof(Real);

    /// Rounds of a step: everything in one of them can be computed at the same time.
    static constexpr int rounds = sum([]<class Pass>(std::type_identity<Pass>) { return Pass::plan.rounds; });
    /// Loops of a step, over particles or over their neighbours.
    static constexpr int loops = sum([]<class Pass>(std::type_identity<Pass>) { return Pass::plan.size; });
    /// Sweeps over the neighbours of phase P in a step.
    template <class P>
    static constexpr int sweeps = sum([]<class Pass>(std::type_identity<Pass>) {
        return Pass::plan.sweeps(Scene::template phase_index<P>);
    });

    /// The numbers that the sweeps over the neighbours of a link load in a step for one of them; for reports.
    template <class L>
    static constexpr int loads_of_link = sum([]<class Pass>(std::type_identity<Pass>) {
        return detail::PassLoads<dim, Pass>::template loads<L>;
    });
    /// How many numbers the sweeps of phase P load in a step for one neighbour of phase B: its position, once a sweep,
    /// and the fields that terms read of it, once a sweep for all terms. Both count twice if it is a neighbour both now
    /// and in the stress-free solid, or also of a term with a longer range.
    template <class P, class B>
    static constexpr int loads = loads_between<P, B>(typename detail::LinksOf<dim, typename Scene::Nodes>::type{});
};

} // namespace imbibe
