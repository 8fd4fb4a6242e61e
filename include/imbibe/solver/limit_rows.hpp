// The time step limits of a scene: a row for each term that has one, made at compile time; and the rules for terms with
// limits.
#pragma once

#include <imbibe/solver/engine.hpp>
#include <imbibe/solver/rules.hpp>

#include <array>

namespace imbibe::detail {

struct Acceleration; ///< the limit on how far an acceleration throws a particle, which belongs to no term

/// Can a limit be asked for with these materials?
template <class Term, class... M>
constexpr bool has_limit() {
    if constexpr (requires(const M&... m, const TimeStepInput& in) { Term::time_step_limit(m..., in); })
        return true;
    else if constexpr (requires { typename Term::Parameters; })
        return requires(const M&... m, const TimeStepInput& in, const typename Term::Parameters& parameters) {
            Term::time_step_limit(m..., in, parameters);
        };
    else
        return false;
}
/// Does the term read positions of something that it moves, without a time step limit?
template <class Term, class Where, class... Materials>
constexpr bool check_force() {
    constexpr bool is_force = []<class... Part>(TypeList<Part...>) {
        return (contains<Position, typename ReadsOf<Part>::type> || ...) &&
               (contains<Rate<Velocity>, typename AddsOf<Part>::type> || ...);
    }(PartList<Term>{});
    if constexpr (is_force && (Materials::moves || ...) && !has_limit<Term, Materials...>())
        return break_rule<rules::ForceOfPositionsWithoutLimit<
            Term, Where, write_a_time_step_limit_with_a_limit_name_or_derive_it_from_NotStiff>>();
    else
        return true;
}
/// Has the term both a limit and its name, or neither? A limit for phases only, or for couplings only, does not count
/// in the others.
template <class Term, class Where, class M, class... Other>
constexpr bool check_limit() {
    constexpr bool callable = has_limit<Term, M, Other...>() || has_limit<Term, M>() || has_limit<Term, M, M>();
    constexpr bool named = requires {
        Term::limit_name;
    };
    constexpr bool there = callable || requires {
        &Term::time_step_limit;
    };
    if constexpr (there != named || callable != named)
        return break_rule<
            rules::LimitNotUsable<Term, write_time_step_limit_of_the_material_and_TimeStepInput_with_a_limit_name>>();
    else
        return check_force<Term, Where, M, Other...>();
}

/// A term's longest step, s; below 0 if it has no limit. It may need no coefficients for it.
/// @tparam Owner the phase or coupling that has its coefficients, @tparam Materials the phase, or both phases
template <class Term, class Owner, class... Materials>
double limit_of_term(const Owner& owner, TimeStepInput in, const Materials&... materials) {
    if constexpr (TermOf<Term, Owner>::says_support)
        in.support_radius = support_of_term<Term>(owner, materials...);
    if constexpr (requires { Term::time_step_limit(materials..., in); })
        return Term::time_step_limit(materials..., in);
    else if constexpr (requires { typename Term::Parameters; })
        if constexpr (const auto& parameters = owner.coefficients.template get<typename Term::Parameters>();
                      requires { Term::time_step_limit(materials..., in, parameters); })
            return Term::time_step_limit(materials..., in, parameters);
    return -1;
}
template <class Term, class P>
double limit_in_phase(const std::any& owner, const std::any&, const std::any&, const TimeStepInput& in) {
    const P& material = *std::any_cast<P>(&owner);
    return limit_of_term<Term>(material, in, material);
}
template <class Term, class C>
double limit_in_coupling(const std::any& owner, const std::any& first, const std::any& second,
                         const TimeStepInput& in) {
    return limit_of_term<Term>(*std::any_cast<C>(&owner), in, *std::any_cast<typename C::First>(&first),
                               *std::any_cast<typename C::Second>(&second));
}
/// The same for its limit on long steps, those in which a particle moves about its spacing.
template <class Term, class P>
double advection_limit_in_phase(const std::any& owner, const std::any&, const std::any&, const TimeStepInput& in) {
    const P& material = *std::any_cast<P>(&owner);
    return Term::advection_limit(material, in, material.coefficients.template get<typename Term::Parameters>());
}

/// Is a reduction one by Sum, Max or Min?
template <class Reduces, template <class> class Kind>
inline constexpr bool is_reduction_by = false;
template <class Quantity, template <class> class Kind>
inline constexpr bool is_reduction_by<Kind<Quantity>, Kind> = true;

/// The rows of a scene. @tparam Scene a Composition, @tparam Integrator says which limits are on its short steps, if it
/// has some
template <int dim, class Scene, class Integrator>
class IMBIBE_PER_BUILD LimitRows {
    template <class Where, class Term>
    static constexpr bool in_substeps() {
        if constexpr (requires { Integrator::template in_substeps<Where, Term>; })
            return Integrator::template in_substeps<Where, Term>;
        else
            return false;
    }
    using Reductions = typename CollectReductions<typename Scene::Phases>::type;
    // The reduction of that kind that a term of phase P has among those of the scene, or -1.
    template <class P, class Term, template <class> class Kind, class... N>
    static constexpr int find_reduction(TypeList<N...>) {
        int at = -1, k = 0;
        ((std::is_same_v<typename N::A, P> && std::is_same_v<typename N::Term, Term> &&
                  is_reduction_by<typename N::Part::reduces, Kind>
              ? at = k++
              : k++),
         ...);
        return at;
    }

    template <class P, class Term>
    static constexpr auto row_of_phase_term() {
        if constexpr (!suits<P, Term>) // reported by another rule
            return std::array<LimitRow, 0>{};
        else if constexpr (!check_limit<Term, P, P>())
            return std::array<LimitRow, 0>{};
        else if constexpr (!has_limit<Term, P>())
            return std::array<LimitRow, 0>{};
        else {
            LimitRow row{.phase = Scene::template phase_index<P>,
                         .reason = Term::limit_name,
                         .seconds = &limit_in_phase<Term, P>,
                         .of_substeps = in_substeps<P, Term>()};
            row.greatest = find_reduction<P, Term, Max>(Reductions{});
            row.least = find_reduction<P, Term, Min>(Reductions{});
            return std::array{row};
        }
    }
    template <class C, class Term>
    static constexpr auto row_of_coupling_term() {
        using A = typename C::First;
        using B = typename C::Second;
        if constexpr (!check_limit<Term, C, A, B>())
            return std::array<LimitRow, 0>{};
        else if constexpr (!has_limit<Term, A, B>())
            return std::array<LimitRow, 0>{};
        else
            return std::array{LimitRow{.kind = LimitKind::of_coupling,
                                       .phase = Scene::template phase_index<A>,
                                       .other = Scene::template phase_index<B>,
                                       .coupling = index_of<C, typename Scene::Couplings>,
                                       .reason = Term::limit_name,
                                       .seconds = &limit_in_coupling<Term, C>,
                                       .of_substeps = in_substeps<C, Term>()}};
    }
    template <class P>
    static constexpr auto row_of_acceleration() {
        if constexpr (P::moves)
            return std::array{LimitRow{.kind = LimitKind::of_acceleration,
                                       .phase = Scene::template phase_index<P>,
                                       .reason = "acceleration",
                                       .of_substeps = in_substeps<P, Acceleration>()}};
        else
            return std::array<LimitRow, 0>{};
    }
    template <class P, class Term>
    static constexpr auto advection_row_of_term() {
        if constexpr (requires { typename Term::Parameters; } && !in_substeps<P, Term>())
            if constexpr (requires(const P& material, const TimeStepInput& in,
                                   const typename Term::Parameters& parameters) {
                              Term::advection_limit(material, in, parameters);
                          })
                return std::array{LimitRow{.phase = Scene::template phase_index<P>,
                                           .reason = Term::advection_limit_name,
                                           .seconds = &advection_limit_in_phase<Term, P>}};
            else
                return std::array<LimitRow, 0>{};
        else
            return std::array<LimitRow, 0>{};
    }
    template <std::size_t... n>
    static constexpr auto joined(const std::array<LimitRow, n>&... lists) {
        std::array<LimitRow, (n + ... + 0)> all{};
        std::size_t at = 0;
        const auto append = [&](const auto& list) {
            for (const LimitRow& row : list)
                all[at++] = row;
        };
        (append(lists), ...);
        return all;
    }
    template <class P, class... Term>
    static constexpr auto rows_of_phase(TypeList<Term...>) {
        return joined(row_of_phase_term<P, Term>()..., row_of_acceleration<P>());
    }
    template <class C, class... Term>
    static constexpr auto rows_of_coupling(TypeList<Term...>) {
        return joined(row_of_coupling_term<C, typename Listed<Term>::Term>()...);
    }
    template <class P, class... Term>
    static constexpr auto advection_rows_of(TypeList<Term...>) {
        if constexpr (requires { Integrator::limits_advection; })
            return joined(std::array{LimitRow{.kind = LimitKind::of_advection,
                                              .phase = Scene::template phase_index<P>,
                                              .reason = "advection"}},
                          advection_row_of_term<P, Term>()...);
        else
            return std::array<LimitRow, 0>{};
    }
    template <class... P, class... C>
    static constexpr auto all_rows(TypeList<P...>, TypeList<C...>) {
        return joined(rows_of_phase<P>(typename P::terms{})..., rows_of_coupling<C>(typename C::terms{})...,
                      advection_rows_of<P>(typename P::terms{})...);
    }

public:
    /// In the order of phases and couplings.
    static constexpr auto rows = all_rows(typename Scene::Phases{}, typename Scene::Couplings{});
};

} // namespace imbibe::detail
