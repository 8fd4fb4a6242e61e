// What is an error before a scene runs: coefficients and materials that a term cannot work with, particles of another
// material in one phase, two couplings that disagree about a part they share.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/phase.hpp>
#include <imbibe/solver/material_numbers.hpp>

#include <string>
#include <type_traits>

namespace imbibe::detail {

/// Asks a term whether the coefficients of its owner (a phase or a coupling), and the owner itself, are what it needs.
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
    // What is no term, as Into in a phase, is an error of its own.
    [[maybe_unused]] const auto check = [&]<class T>(std::type_identity<T>) {
        if constexpr (IsTerm<T>)
            check_term<T>(owner, type_name<Where>());
    };
    if constexpr (requires { typename Owner::First; })
        (check(std::type_identity<typename Listed<Term>::Term>{}), ...);
    else
        (check(std::type_identity<Term>{}), ...);
}

/// Throws Error unless particles that are added to a phase are of the material that it has, with its spacing, its
/// support radius and its coefficients.
template <class P>
void require_same_material(const P& phase, const P& added, const std::string& name) {
    const NamedNumbers before = numbers_of_owner(phase), now = numbers_of_owner(added);
    for (std::size_t k = 0; k < before.size(); ++k)
        require(before[k] == now[k], name, ": particles were added with ", before[k].first, " ", before[k].second,
                " before and ", now[k].second, " now; use a second phase for a second material or spacing, or change ",
                "that of all particles by scene[phase].material()");
}

/// Throws Error if two couplings give different coefficients to one part of one phase, which both ask for.
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

} // namespace imbibe::detail
