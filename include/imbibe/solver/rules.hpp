// The rules a scene must keep, each a template whose name is the rule and whose arguments are the culprits: what the
// compiler prints is the diagnosis, and the remedy is a type whose name is the advice.
#pragma once

namespace imbibe {

// Advice, printed as a template argument.
struct add_a_term_that_sets_it_such_as_an_equation_of_state_for_pressure;
struct remove_one_of_the_two_terms;
struct list_every_phase_of_a_coupling_in_the_solver;
struct list_each_phase_and_coupling_once;
struct give_the_term_to_the_phase_or_use_current_neighbours;
struct make_one_of_the_two_terms_read_something_else;
struct use_fewer_terms_or_raise_the_limits_in_schedule_hpp;

namespace rules {

/// False, whatever it is given.
template <class...>
inline constexpr bool never = false;

/// Rule: a field that a term reads must be set by some term of its phase.
template <class Field, class Term, class Phase, class Advice>
struct NobodySets {
    static_assert(never<Field>, "imbibe: a term reads this field, and no term of its phase sets it");
};
/// Rule: a field is set by one term only.
template <class Field, class TermOne, class TermTwo, class Phase, class Advice>
struct SetTwice {
    static_assert(never<Field>, "imbibe: two terms of one phase set the same field");
};
/// Rule: no two terms wait for each other.
template <class TermOne, class TermTwo, class Advice>
struct Cycle {
    static_assert(never<TermOne>, "imbibe: these terms wait for each other's results");
};
/// Rule: a coupling names phases of the scene.
template <class Phase, class Coupling, class Advice>
struct NoSuchPhase {
    static_assert(never<Phase>, "imbibe: this coupling names a phase that the scene does not have");
};
/// Rule: a sum over the neighbours of the stress-free configuration is one within a phase.
template <class Term, class Coupling, class Advice>
struct ReferenceNeighboursInCoupling {
    static_assert(never<Term>, "imbibe: a coupling has no reference neighbours, a phase keeps those of its own only");
};
/// Rule: phases are told apart by their type, so each appears once.
template <class Phase, class Advice>
struct SamePhaseTwice {
    static_assert(never<Phase>, "imbibe: this phase or coupling is listed twice, or a phase is coupled to itself");
};
/// Rule: a scene fits into the schedule's tables.
template <class EvaluatedOnce, class Advice>
struct TooLarge {
    static_assert(never<EvaluatedOnce>, "imbibe: the scene has more terms or fields than the schedule has room for");
};

} // namespace rules
} // namespace imbibe
