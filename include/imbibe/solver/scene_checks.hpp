// Errors before a scene runs: coefficients and materials that a term cannot use, particles of another material in one
// phase, two couplings that disagree about a shared part; and names that are not of the scene.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/phase.hpp>
#include <imbibe/solver/material_numbers.hpp>
#include <imbibe/solver/passes.hpp>
#include <imbibe/solver/population.hpp>
#include <imbibe/solver/rules.hpp>

#include <string>
#include <type_traits>

namespace imbibe::detail {

/// Lets a term check the coefficients of its owner (a phase or a coupling), and the owner itself.
template <class Term, class Owner>
void check_term(const Owner& owner, const std::string& name) {
    if constexpr (requires { typename Term::Parameters; }) {
        const auto& parameters = owner.coefficients.template get<typename Term::Parameters>();
        if constexpr (requires { parameters.check(name); })
            parameters.check(name);
    }
    if constexpr (requires { Term::check(owner, name); })
        Term::check(owner, name);
}
template <class Where, class Owner, class... Term>
void check_terms(const Owner& owner, TypeList<Term...>) {
    // A type that is no term, such as Into in a phase, is an error of its own.
    [[maybe_unused]] const auto check = [&]<class T>(std::type_identity<T>) {
        if constexpr (IsTerm<T>)
            check_term<T>(owner, type_name<Where>());
    };
    if constexpr (requires { typename Owner::First; })
        (check(std::type_identity<typename Listed<Term>::Term>{}), ...);
    else
        (check(std::type_identity<Term>{}), ...);
}

/// Throws Error unless particles that are added to a phase have its material, spacing, support radius and coefficients.
template <class P>
void require_same_material(const P& phase, const P& added, const std::string& name) {
    const NamedNumbers before = numbers_of_owner(phase), now = numbers_of_owner(added);
    for (std::size_t k = 0; k < before.size(); ++k)
        require(before[k] == now[k], name, ": particles were added with ", before[k].first, " ", before[k].second,
                " before and ", now[k].second, " now; use a second phase for a second material or spacing, or change ",
                "that of all particles by scene[phase].material()");
}

/// Throws Error if two couplings give different coefficients to a part of a phase that both need.
template <class P, class Term, class C, class D>
void check_shared(const C& one, const D& other) {
    if constexpr (requires { typename Term::Parameters; }) {
        using Parameters = typename Term::Parameters;
        if constexpr (requires(const Parameters& p) { p == p; })
            require(one.coefficients.template get<Parameters>() == other.coefficients.template get<Parameters>(),
                    type_name<C>(), " and ", type_name<D>(), " give ", type_name<P>(), " different ",
                    type_name<Parameters>(), ", and both count in one ", type_name<Term>(),
                    "; set the same in both couplings");
    }
}
/// The same for all terms of two couplings.
template <class C, class D, class... TermC>
void check_shared_parts(const C& one, const D& other, TypeList<TermC...>) {
    [[maybe_unused]] const auto check = [&]<class P, class Term>(std::type_identity<Into<P, Term>>) {
        if constexpr (contains<Into<P, Term>, typename D::terms>)
            check_shared<P, Term>(one, other);
    };
    [[maybe_unused]] const auto each = [&]<class T>(std::type_identity<T> term) {
        if constexpr (!std::is_same_v<T, typename Listed<T>::Term>)
            check(term);
    };
    (each(std::type_identity<TermC>{}), ...);
}

template <class Engine, class... P>
void check_phases(const Engine& engine, TypeList<P...>) {
    [[maybe_unused]] const auto check = [&]<class Q>(std::type_identity<Q>, const auto& s) {
        if (s.size() > 0) {
            s.material.check(type_name<Q>());
            require_support(engine, s.material.support_radius, type_name<Q>());
            check_terms<Q>(s.material, typename Q::terms{});
        }
    };
    (check(std::type_identity<P>{}, engine.template state<P>()), ...);
}
template <class C, class Engine, class... D>
void check_shared_with(const Engine& engine, TypeList<D...>) {
    (check_shared_parts(engine.template coupling<C>(), engine.template coupling<D>(), typename C::terms{}), ...);
}
template <class Engine, class... C>
void check_couplings(const Engine& engine, [[maybe_unused]] TypeList<C...> all) {
    (check_terms<C>(engine.template coupling<C>(), typename C::terms{}), ...);
    (check_shared_with<C>(engine, all), ...);
}
/// Throws Error for a material or a coefficient of a scene that is out of range, or that a term cannot use.
template <class Engine>
void check_numbers_of(const Engine& engine) {
    check_phases(engine, typename Engine::Phases{});
    check_couplings(engine, typename Engine::Couplings{});
    require_supports_of_terms(engine);
}

/// True, or a compile error: What, a phase or a coupling, is in the list All of a scene.
template <class What, class All, class Advice>
constexpr bool in_the_scene() {
    if constexpr (!contains<What, All>)
        return break_rule<rules::NotInTheScene<What, Advice>>();
    else
        return true;
}
/// The first of the phases with an implicit acceleration; void if none has one.
template <class Scene>
constexpr auto first_with_implicit(TypeList<>) {
    return std::type_identity<void>{};
}
template <class Scene, class P, class... Rest>
constexpr auto first_with_implicit(TypeList<P, Rest...>) {
    if constexpr (P::moves && contains<ImplicitAcceleration, typename Scene::template FieldsOf<P>>)
        return std::type_identity<P>{};
    else
        return first_with_implicit<Scene>(TypeList<Rest...>{});
}
/// True, or a compile error: the scene has the phases and terms that an integrator names, and implicit terms only if it
/// allows them.
template <class Scene, class Integrator>
constexpr bool check_integrator() {
    using Implicit = typename decltype(first_with_implicit<Scene>(typename Scene::Phases{}))::type;
    if constexpr (!std::is_void_v<Implicit> && !requires { requires Integrator::allows_implicit; })
        return break_rule<rules::ImplicitTermsNotAllowed<Integrator, Implicit,
                                                         take_one_that_allows_implicit_such_as_SymplecticEuler>>();
    else if constexpr (requires { typename Integrator::Fast; })
        return in_the_scene<typename Integrator::Fast, typename Scene::Phases, list_the_phase_in_the_solver>();
    else if constexpr (requires { requires Integrator::Slow::size == 0; })
        return break_rule<rules::NothingIsSlow<Integrator, name_terms_such_as_MorrisViscosity>>();
    else if constexpr (requires { typename Integrator::Slow; })
        return RowsOfTerms<Scene, typename Integrator::Slow>::check();
    else
        return true;
}

} // namespace imbibe::detail
