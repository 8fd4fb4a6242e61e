// Lets the terms of a scene compute the numbers that follow from their coefficients, spacing and support radius.
#pragma once

#include <imbibe/core/lattice.hpp>
#include <imbibe/core/phase.hpp>
#include <imbibe/solver/nodes.hpp>

#include <algorithm>
#include <tuple>

namespace imbibe::detail {

/// One term, with the coefficients of its owner, a phase or a coupling.
/// @param spacing the greater one of its phases, m @param support the reach of terms without their own, m
/// @param material the phase, or both phases
template <class Term, int dim, class Owner, class... M>
void prepare_term(Owner& owner, double spacing, double support, const M&... material) {
    if constexpr (TermOf<Term, Owner>::template prepares<dim>) {
        if constexpr (TermOf<Term, Owner>::says_support)
            support = support_of_term<Term>(owner, material...);
        const Lattice<dim> lattice{spacing, support};
        auto& prepared = std::get<typename Term::Prepared>(owner.coefficients.prepared);
        if constexpr (PreparesByLattice<Term, dim, M...>)
            prepared = Term::prepare(material..., lattice);
        else
            prepared =
                Term::prepare(material..., lattice, owner.coefficients.template get<typename Term::Parameters>());
    }
}
template <int dim, class Owner, class... Term, class... M>
void prepare_list([[maybe_unused]] TypeList<Term...> terms, [[maybe_unused]] Owner& owner,
                  [[maybe_unused]] double spacing, [[maybe_unused]] double support, const M&... material) {
    (prepare_term<typename Listed<Term>::Term, dim>(owner, spacing, support, material...), ...);
}
/// All terms of all phases that have particles, and of couplings of two such.
template <class Engine>
void prepare_terms_of(Engine& engine) {
    engine.for_each_phase([]<class P>(std::type_identity<P>, const auto& s) {
        if (s.size() > 0)
            prepare_list<Engine::dimension>(typename P::terms{}, s.material, s.material.spacing,
                                            s.material.support_radius, s.material);
    });
    [[maybe_unused]] const auto prepare = [&engine]<class C>(std::type_identity<C>) {
        using A = typename C::First;
        using B = typename C::Second;
        const auto a = engine.template state<A>();
        const auto b = engine.template state<B>();
        if (a.size() > 0 && b.size() > 0)
            prepare_list<Engine::dimension>(typename C::terms{}, engine.template coupling<C>(),
                                            std::max(a.material.spacing, b.material.spacing),
                                            engine.template support<A, B>(), a.material, b.material);
    };
    [&]<class... C>(TypeList<C...>) { (prepare(std::type_identity<C>{}), ...); }(typename Engine::Couplings{});
}

} // namespace imbibe::detail
