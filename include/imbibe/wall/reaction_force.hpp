// The force of a fluid on a wall or a solid, particle by particle: drag, lift, loads on structures.
#pragma once

#include <imbibe/core/rule.hpp>
#include <imbibe/core/term.hpp>

namespace imbibe {

struct give_it_a_force_of_the_coupling; // advice

namespace rules {
/// Rule: a reaction force names a term whose pairs push.
template <class Term, class Advice>
struct NoForceToReactTo {
    static_assert(sizeof(Term) == 0,
                  "imbibe: ReactionForce is given a term that pushes nothing: give it a force of the "
                  "coupling, such as VolumePressure or NoSlipViscosity");
};
} // namespace rules

/// The force on a particle, N (N/m in 2D); see ReactionForce.
struct ReactionForceField : Field<Rank::vector> {
    static constexpr std::string_view name = "reaction_force", unit = "N";
    static constexpr bool shown = true;
};
inline constexpr ReactionForceField reaction_force{};

namespace detail {

// Minus the force on the other side's particles by a pair part that adds to their acceleration, with that part's
// coefficients.
template <class Part>
struct ReactionTo : Part {
    using reads = Unique<Concat<typename ReadsOf<Part>::type, Fields<mass>>>;
    using adds = Fields<reaction_force>;

    IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        auto ba = ab;
        ba.offset = -ab.offset;
        const auto push = Part::operator()(b, a, ba);
        if constexpr (is_central<std::remove_cvref_t<decltype(push)>>)
            return along(ab, b[mass] * push.factor); // -m_b f (x_b - x_a)
        else
            return -b[mass] * push;
    }
};

template <class Part>
inline constexpr bool pushes = std::is_same_v<typename AddsOf<Part>::type, Fields<acceleration>>;

template <class Term, class Parts>
struct ReactionsTo;
template <class Term, class... Part>
struct ReactionsTo<Term, TypeList<Part...>> {
    static constexpr bool check() {
        if constexpr (!(pushes<Part> || ...))
            return break_rule<rules::NoForceToReactTo<Term, give_it_a_force_of_the_coupling>>();
        return true;
    }
    static_assert(check() || true); // reports what is wrong by itself, once
    using type = Concat<std::conditional_t<pushes<Part>, TypeList<ReactionTo<Part>>, TypeList<>>...>;
};

} // namespace detail

/// F_a = - sum_b m_b (dv_b/dt)_a, in N: the force of the fluid particles b on a particle a of a wall or a solid. It is
/// minus the force on b by the given terms, pair by pair, to the last bit. The terms must be terms of the coupling,
/// with the same kernel.
///
/// Goes into the wall or the solid, beside the terms it is the reaction to:
///
///     struct Contact : Coupling<Water, Pier, Into<Pier, PressureExtrapolation<>>, VolumePressure<>,
///                               Into<Water, VolumeContinuity<>>, Into<Pier, ReactionForce<VolumePressure<>>>> {};
///
/// and the force on the pier is `scene[pier][reaction_force].colwise().sum()`, as it was where the last step began.
/// Near an edge where two walls meet, the water's particles push at both: the force on a part of a wall is right to
/// about what lies within a support of its rim.
///
/// Not the pressure of PressureExtrapolation, which continues that of the water: in an impact a tongue of water thinner
/// than the support pushes on part of the wall only, but shows its pressure all around.
///
/// Not into a fluid. It costs one more sweep: leave it out where the force is not needed.
///
/// Source: Newton's third law.
template <class... Term>
struct ReactionForce {
    static constexpr bool one_sided = true;
    using reacts_to = TypeList<Term...>;
    using parts = detail::Concat<typename detail::ReactionsTo<Term, detail::PartList<Term>>::type...>;
};

} // namespace imbibe
