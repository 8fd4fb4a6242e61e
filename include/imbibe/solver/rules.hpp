// The rules for scenes, each a template whose name is the rule and whose arguments are the culprits: the compiler
// prints the diagnosis, and the remedy is a type whose name is the advice.
#pragma once

namespace imbibe {

// Advice, printed as a template argument.
struct add_a_term_that_sets_it;
struct add_an_equation_of_state_such_as_Tait;
struct add_PressureExtrapolation_to_the_coupling_Into_the_wall;
struct write_it_in_a_coupling_as_Into_the_wall_or_solid;
struct remove_one_of_the_two_terms;
struct list_it_once;
struct list_it_in_the_phases_only;
struct use_the_RiemannWall_terms_at_walls_and_solids;
struct list_it_between_a_fluid_and_a_wall_or_solid;
struct use_VolumePressure_RiemannPressure_or_MorrisViscosity_between_fluids;
struct list_it_in_a_coupling_of_the_fluid;
struct give_it_a_force_that_the_coupling_lists;
struct give_both_the_same_kernel;
struct list_terms_only_and_Into_only_in_couplings;
struct give_it_to_a_solid;
struct list_it_where_a_phase_has_a_viscosity_as_fluids_and_walls_do;
struct let_the_part_add_to_the_field;
struct let_the_part_add_to_its_rate_or_set_it;
struct write_time_step_limit_of_the_material_and_TimeStepInput_with_a_limit_name;
struct write_a_time_step_limit_with_a_limit_name_or_derive_it_from_NotStiff;
struct couple_two_different_phases;
struct list_the_phase_in_the_solver;
struct list_the_coupling_in_the_solver;
struct list_a_term_that_uses_it_or_look_at_another;
struct write_float_or_double;
struct give_it_one_such_as_SymplecticEuler;
struct list_structs_derived_from_Fluid_Solid_Wall_or_Coupling;
struct put_an_integrator_such_as_SymplecticEuler_before_the_phases;
struct list_every_phase_of_a_coupling_in_the_solver;
struct give_it_two_phases_before_its_terms;
struct write_Into_with_the_phase_before_the_term;
struct write_using_parts_Parts_of_it;
struct give_the_part_that_uses_them_a_member_of_this_type_named_parameters;
struct list_it_in_a_phase_or_coupling_or_do_not_name_it;
struct let_every_short_step_evaluate_it;
struct name_terms_such_as_MorrisViscosity;
struct list_it_in_the_coupling_Into_the_phase;
struct list_each_phase_and_coupling_once;
struct list_the_term_Clamped_in_the_phase;
struct take_one_that_allows_implicit_such_as_SymplecticEuler;
struct remove_particles_of_other_phases_only;
struct give_the_term_to_the_phase_or_use_current_neighbours;
struct write_static_Prepared_prepare_of_a_material_or_two_and_a_Lattice;
struct take_a_solid_with_a_stress_rate;
struct derive_the_phase_from_Wall_to_prescribe_its_motion;
struct remove_its_support_radius_or_use_current_neighbours;
struct write_static_double_support_radius_of_a_material_or_of_two;
struct make_one_of_the_two_terms_read_something_else;
struct use_fewer_terms_or_raise_the_limits_in_schedule_hpp;

namespace rules {

/// False for any arguments.
template <class...>
inline constexpr bool never = false;

/// Rule: a field that a term reads must be set by some term of its phase.
template <class Field, class Term, class Phase, class Advice>
struct NobodySets {
    static_assert(never<Field>, "imbibe: a term reads this field, and no term of its phase sets it");
};
/// Rule: phases and couplings list terms.
template <class What, class Where, class Advice>
struct NotATerm {
    static_assert(never<What>, "imbibe: this is listed where a term is expected, and is none");
};
/// Rule: a term lists its parts, even where it has one.
template <class Given, class Term, class Advice>
struct PartsAreNoList {
    static_assert(never<Given>, "imbibe: the `parts` of this term are no list: write `using parts = Parts<...>;`");
};
/// Rule: the parameters of a term are given to it: a part has a member of that name and type, or a limit on the step,
/// its support radius or what it prepares takes them.
template <class Parameters, class Term, class Advice>
struct ParametersNotTaken {
    static_assert(never<Parameters>,
                  "imbibe: nothing in this term takes its `Parameters`: what is set would be ignored");
};
/// Rule: a term that prepares numbers has the function that does so.
template <class Prepared, class Term, class Advice>
struct PreparedByNoFunction {
    static_assert(never<Prepared>, "imbibe: this term has `Prepared`, and no function `prepare` that returns one");
};
/// Rule: a term that needs elastic moduli belongs to a phase that has them.
template <class Term, class Phase, class Advice>
struct NotASolid {
    static_assert(never<Term>, "imbibe: this term asks for the elastic moduli of a solid, and its phase has none");
};
/// Rule: a term is listed once; a second time would count twice.
template <class Term, class Where, class Advice>
struct TermTwice {
    static_assert(never<Term>, "imbibe: the same term is listed twice");
};
/// Rule: a phase, or a side of a coupling, has only one form of an equation.
template <class Effect, class TermOne, class TermTwo, class Where, class Advice>
struct SameEffectTwice {
    static_assert(never<Effect>, "imbibe: two terms are forms of the same equation, which would count twice");
};
/// Rule: if a term of a phase needs another in its couplings (`beside_in_couplings`), every coupling with a form of the
/// same equation has it.
template <class Missing, class Term, class Phase, class Coupling, class Advice>
struct MissingInCoupling {
    static_assert(never<Missing>, "imbibe: a term of this phase needs another in this coupling");
};
/// Rule: a term of a phase does not stand beside a coupling term that spoils it (`never_in_couplings`).
template <class Found, class Term, class Phase, class Coupling, class Advice>
struct NeverInCoupling {
    static_assert(never<Found>, "imbibe: a term of this phase is wrong beside this one in a coupling");
};
/// Rule: a term that only one side of a coupling can have (`one_sided`) names the side.
template <class Term, class Where, class Advice>
struct NotInto {
    static_assert(never<Term>, "imbibe: this term is one of a wall or a solid beside a fluid, and acts on just that");
};
/// Rule: a term that compares neighbours of one material (`within_phases`) belongs to a phase.
template <class Term, class Coupling, class Advice>
struct NotInCouplings {
    static_assert(never<Term>, "imbibe: this term compares neighbours of one material, and is listed in a coupling");
};
/// Rule: a force of walls or solids on fluids (`between_fluid_and_other`) belongs to a coupling.
template <class Term, class Phase, class Advice>
struct NotInPhases {
    static_assert(never<Term>, "imbibe: this term goes between a fluid and a wall or a solid, and is listed in a phase");
};
/// Rule: a reaction (`reacts_to`) names terms of the same coupling.
template <class Term, class Reaction, class Coupling, class Advice>
struct NothingToReactTo {
    static_assert(never<Term>, "imbibe: this force is none of the coupling, which lists a reaction to it");
};
/// Rule: dual stepping names the terms that a long step evaluates once.
template <class Integrator, class Advice>
struct NothingIsSlow {
    static_assert(never<Integrator>, "imbibe: DualStepping names no term to be evaluated once in a long step");
};
/// Rule: a term that needs a viscosity (`needs_viscosity`) belongs to a phase or coupling that has one.
template <class Term, class Where, class Advice>
struct NoViscosity {
    static_assert(never<Term>, "imbibe: this term asks for a viscosity, and there is none");
};
/// Rule: a term that needs a fluid's state on both sides (`between_fluids`) belongs to a fluid, or to a coupling of
/// two.
template <class Term, class Coupling, class Advice>
struct NotBetweenFluids {
    static_assert(never<Term>, "imbibe: this term goes between fluids, and a side of this coupling is none");
};
/// Rule: a force of walls or solids on fluids (`between_fluid_and_other`) has a fluid on one side only.
template <class Term, class Coupling, class Advice>
struct NotBetweenFluidAndWall {
    static_assert(never<Term>, "imbibe: this term goes between a fluid and a wall or a solid");
};
/// Rule: gradients and their correction have the same kernel (`corrected_kernel`).
template <class KernelOne, class KernelTwo, class TermOne, class TermTwo, class Where, class Advice>
struct TwoKernels {
    static_assert(never<KernelOne>, "imbibe: a gradient and its correction are made with two kernels");
};
/// Rule: a function of a pair adds to fields; it cannot set one.
template <class Part, class Term, class Advice>
struct PairPartSets {
    static_assert(never<Part>, "imbibe: a function of a pair can only add to fields, and this one sets one");
};
/// Rule: a field that terms add to starts from zero in every step, so it is no state.
template <class Field, class Term, class Phase, class Advice>
struct AddsToAState {
    static_assert(never<Field>, "imbibe: a term adds to a state, which would start from zero in every step");
};
/// Rule: a limit on the step is a function of the material and a TimeStepInput (and the parameters), and has a name.
template <class Term, class Advice>
struct LimitNotUsable {
    static_assert(never<Term>, "imbibe: this term's limit on the step has no name, or cannot be called");
};
/// Rule: a force that reads positions has a time step limit, because only the term knows how stiff it is.
template <class Term, class Where, class Advice>
struct ForceOfPositionsWithoutLimit {
    static_assert(never<Term>,
                  "imbibe: this term's force depends on positions, and it does not say what steps it bears");
};
/// Rule: a field can be viewed only if a term of the phase uses it.
template <class Field, class Phase, class Advice>
struct FieldNotStored {
    static_assert(never<Field>, "imbibe: no term of this phase uses this field, so it is not stored");
};
/// Rule: the second argument of a solver is the type of its numbers.
template <class Given, class Advice>
struct NotRealNumbers {
    static_assert(never<Given>, "imbibe: the numbers of a scene are float or double");
};
/// Rule: the third argument of a solver is its integrator.
template <class Given, class Advice>
struct NoIntegrator {
    static_assert(never<Given>, "imbibe: the solver has no integrator, but this phase or coupling in its place");
};
/// Rule: an integrator has a step of the engine.
template <class Given, class Advice>
struct NotAnIntegrator {
    static_assert(never<Given>, "imbibe: the third argument of a solver is no integrator");
};
/// Rule: implicit terms need an integrator that evaluates all terms once a step.
template <class Given, class Phase, class Advice>
struct ImplicitTermsNotAllowed {
    static_assert(never<Given>, "imbibe: a term of this phase adds an implicit acceleration, which needs all others of "
                                "the same step; this integrator has them at several times");
};
/// Rule: after the integrator a solver lists its phases and couplings.
template <class Given, class Advice>
struct NotAPhaseOrCoupling {
    static_assert(never<Given>, "imbibe: the solver lists this, which is no phase and no coupling");
};
/// Rule: a field is set by one term only.
template <class Field, class TermOne, class TermTwo, class Phase, class Advice>
struct SetTwice {
    static_assert(never<Field>, "imbibe: two terms of one phase set the same field");
};
/// Rule: a field that is computed once is not computed in every step as well, which would start it anew.
template <class Field, class Phase, class Advice>
struct OnceAndInEveryStep {
    static_assert(never<Field>, "imbibe: terms compute this field once, and others in every step");
};
/// Rule: no two terms depend on each other.
template <class TermOne, class TermTwo, class Advice>
struct Cycle {
    static_assert(never<TermOne>, "imbibe: these terms wait for each other's results");
};
/// Rule: a coupling names phases of the scene.
template <class Phase, class Coupling, class Advice>
struct NoSuchPhase {
    static_assert(never<Phase>, "imbibe: this coupling names a phase that the scene does not have");
};
/// Rule: a coupling is one of two phases, and sends a term into one of them.
template <class Given, class Coupling, class Advice>
struct NotAPhase {
    static_assert(never<Given>, "imbibe: this stands in a coupling where a phase is expected, and is none");
};
/// Rule: a phase or coupling that a program or an integrator names belongs to the scene.
template <class What, class Advice>
struct NotInTheScene {
    static_assert(never<What>, "imbibe: the scene does not have this phase or coupling");
};
/// Rule: the terms that an integrator evaluates less often than others are terms of the scene.
template <class Term, class Advice>
struct TermNotInTheScene {
    static_assert(never<Term>, "imbibe: the integrator names this term, which no phase or coupling of the scene lists");
};
/// Rule: a term that is evaluated once in a long step adds to no rate by which every short step advances a state.
template <class State, class Term, class Advice>
struct SlowTermOfState {
    static_assert(never<Term>, "imbibe: a term that is to be evaluated less often changes a state in every short step");
};
/// Rule: a phase with held particles has the term for holding them.
template <class Phase, class Advice>
struct HeldWithoutClamped {
    static_assert(never<Phase>, "imbibe: particles of this phase are to be held, and it has no term that holds them");
};
/// Rule: a phase whose sums go over the neighbours of the stress-free configuration keeps its particles.
template <class Phase, class Advice>
struct RemovedFromReference {
    static_assert(never<Phase>, "imbibe: the particles of a total-Lagrangian phase cannot be removed");
};
/// Rule: particles cannot be handed over to a total-Lagrangian solid, in which they have no stress-free position.
template <class Phase, class Advice>
struct HandedToReference {
    static_assert(never<Phase>, "imbibe: particles cannot be handed over to a total-Lagrangian phase");
};
/// Rule: a sum over the neighbours of the stress-free configuration is one within a phase.
template <class Term, class Coupling, class Advice>
struct ReferenceNeighboursInCoupling {
    static_assert(never<Term>, "imbibe: a coupling has no reference neighbours, a phase keeps those of its own only");
};
/// Rule: a term with a support radius of its own sums over present neighbours.
template <class Term, class Owner, class Advice>
struct OwnSupportOfReferenceNeighbours {
    static_assert(never<Term>, "imbibe: a sum over reference neighbours reaches as far as its phase, not further");
};
/// Rule: a term's own support radius is a function of its phase, or of both phases of a coupling.
template <class Term, class Owner, class Advice>
struct SupportRadiusNotUsable {
    static_assert(never<Term>, "imbibe: this term's support_radius cannot be asked for");
};
/// Rule: fluids and solids move freely, walls as prescribed or not at all.
template <class Phase, class Advice>
struct MotionOfAnotherKind {
    static_assert(never<Phase>, "imbibe: fluids and solids are Free, walls are Placed or Prescribed");
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
