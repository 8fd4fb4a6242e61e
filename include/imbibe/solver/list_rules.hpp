// The rules for a scene's phases, couplings and terms as listed, checked first.
#pragma once

#include <imbibe/solver/nodes.hpp>
#include <imbibe/solver/rules.hpp>

#include <type_traits>

namespace imbibe::detail {

/// @tparam Items the phases and couplings of a scene
template <class... Items>
struct ListRules {
    /// True, or a compile error that names the broken rule.
    static constexpr bool check() {
        if constexpr ((check_item<Items>() && ...))
            if constexpr ((check_phases_of<Items>() && ...))
                return (check_listed_once<Items>() && ...) && (check_terms<Items>(typename Items::terms{}) && ...) &&
                       (check_company<Items>() && ...);
        return false;
    }

private:
    template <class Item>
    static constexpr bool check_item() {
        if constexpr (!IsPhase<Item> && !IsCoupling<Item>)
            return break_rule<
                rules::NotAPhaseOrCoupling<Item, list_structs_derived_from_Fluid_Solid_Wall_or_Coupling>>();
        else if constexpr (has_motion_of_another_kind<Item>())
            return break_rule<rules::MotionOfAnotherKind<Item, derive_the_phase_from_Wall_to_prescribe_its_motion>>();
        else
            return true;
    }
    template <class Item>
    static constexpr bool has_motion_of_another_kind() {
        if constexpr (IsPhase<Item>)
            return Item::moves != std::is_same_v<typename Item::motion, Free>;
        else
            return false;
    }
    template <class P>
    static constexpr bool check_listed_once() {
        if constexpr (((std::is_same_v<P, Items> ? 1 : 0) + ...) > 1)
            return break_rule<rules::SamePhaseTwice<P, list_each_phase_and_coupling_once>>();
        else
            return true;
    }
    template <class P, class C, class Allowed, class Advice>
    static constexpr bool check_named() {
        if constexpr (!IsPhase<P>)
            return break_rule<rules::NotAPhase<P, C, Advice>>();
        else if constexpr (!contains<P, Allowed>)
            return break_rule<rules::NoSuchPhase<P, C, list_every_phase_of_a_coupling_in_the_solver>>();
        else
            return true;
    }
    template <class C, class... P>
    static constexpr bool check_targets(TypeList<P...>) {
        using Two = TypeList<typename C::First, typename C::Second>;
        return (check_named<P, C, Two, write_Into_with_the_phase_before_the_term>() && ...);
    }
    template <class C>
    static constexpr bool check_phases_of() {
        if constexpr (!IsCoupling<C>)
            return true;
        else if constexpr (std::is_same_v<typename C::First, typename C::Second>)
            return break_rule<rules::SamePhaseTwice<typename C::First, couple_two_different_phases>>();
        else
            return check_named<typename C::First, C, TypeList<Items...>, give_it_two_phases_before_its_terms>() &&
                   check_named<typename C::Second, C, TypeList<Items...>, give_it_two_phases_before_its_terms>() &&
                   check_targets<C>(typename TargetsOf<typename C::terms>::type{});
    }
    template <class T, class U>
    static constexpr bool overlap = std::is_void_v<typename Listed<T>::On> || std::is_void_v<typename Listed<U>::On> ||
                                    std::is_same_v<typename Listed<T>::On, typename Listed<U>::On>;
    template <class C, class Term>
    static constexpr bool check_coupled_term() {
        constexpr int fluids = is_fluid<typename C::First> + is_fluid<typename C::Second>;
        if constexpr (requires { requires Term::within_phases; })
            return break_rule<rules::NotInCouplings<Term, C, list_it_in_the_phases_only>>();
        else if constexpr (requires { requires Term::between_fluids && fluids != 2; })
            return break_rule<rules::NotBetweenFluids<Term, C, use_the_RiemannWall_terms_at_walls_and_solids>>();
        else if constexpr (requires { requires Term::between_fluid_and_other && fluids == 2; })
            return break_rule<rules::NotBetweenFluidAndWall<
                Term, C, use_VolumePressure_RiemannPressure_or_MorrisViscosity_between_fluids>>();
        else if constexpr (requires { requires Term::between_fluid_and_other && fluids == 0; })
            return break_rule<rules::NotBetweenFluidAndWall<Term, C, list_it_between_a_fluid_and_a_wall_or_solid>>();
        else if constexpr (requires { typename Term::reacts_to; })
            return check_reaction<C, Term>(typename Term::reacts_to{});
        else
            return true;
    }
    template <class C, class Reaction>
    static constexpr bool check_reaction(TypeList<>) {
        return true;
    }
    template <class C, class Reaction, class Force, class... Rest>
    static constexpr bool check_reaction(TypeList<Force, Rest...>) {
        if constexpr (!lists<Force>(typename C::terms{}))
            return break_rule<rules::NothingToReactTo<Force, Reaction, C, give_it_a_force_that_the_coupling_lists>>();
        else
            return check_reaction<C, Reaction>(TypeList<Rest...>{});
    }
    template <class Term, class... T>
    static constexpr bool lists(TypeList<T...>) {
        return (std::is_same_v<typename Listed<T>::Term, Term> || ...);
    }
    template <class Item>
    static constexpr bool has_viscosity() {
        if constexpr (IsCoupling<Item>)
            return has_viscosity<typename Item::First>() || has_viscosity<typename Item::Second>();
        else
            return requires(const Item& phase) {
                phase.viscosity;
            };
    }
    template <class Item, class T>
    static constexpr bool check_term() {
        using Term = typename Listed<T>::Term;
        if constexpr (!IsTerm<Term> || (!std::is_same_v<Term, T> && !IsCoupling<Item>))
            return break_rule<rules::NotATerm<T, Item, list_terms_only_and_Into_only_in_couplings>>();
        else if constexpr (!lists_its_parts<Term>)
            return break_rule<rules::PartsAreNoList<typename Term::parts, Term, write_using_parts_Parts_of_it>>();
        else if constexpr (!IsCoupling<Item> && !suits<Item, Term>)
            return break_rule<rules::NotASolid<Term, Item, give_it_to_a_solid>>();
        else if constexpr (requires { requires Term::needs_viscosity; } && !has_viscosity<Item>())
            return break_rule<
                rules::NoViscosity<Term, Item, list_it_where_a_phase_has_a_viscosity_as_fluids_and_walls_do>>();
        else if constexpr (std::is_same_v<Term, T> && requires { requires Term::one_sided; })
            return break_rule<rules::NotInto<Term, Item, write_it_in_a_coupling_as_Into_the_wall_or_solid>>();
        else if constexpr (IsCoupling<Item>)
            return check_coupled_term<Item, Term>();
        else if constexpr (requires { requires Term::between_fluid_and_other; })
            return break_rule<rules::NotInPhases<Term, Item, list_it_in_a_coupling_of_the_fluid>>();
        else
            return true;
    }
    template <class Item, class T, class U>
    static constexpr bool check_two() {
        using One = typename Listed<T>::Term;
        using Two = typename Listed<U>::Term;
        if constexpr (!overlap<T, U>)
            return true;
        else if constexpr (std::is_same_v<One, Two>)
            return break_rule<rules::TermTwice<One, Item, list_it_once>>();
        else if constexpr (requires { requires std::is_same_v<typename One::effect, typename Two::effect>; })
            return break_rule<
                rules::SameEffectTwice<typename One::effect, One, Two, Item, remove_one_of_the_two_terms>>();
        else
            return true;
    }
    template <class Item>
    static constexpr bool check_twos(TypeList<>) {
        return true;
    }
    template <class Item, class T, class... Rest>
    static constexpr bool check_twos(TypeList<T, Rest...>) {
        return (check_two<Item, T, Rest>() && ...) && check_twos<Item>(TypeList<Rest...>{});
    }
    // One: the first term before these that has a kernel of the kind, or void.
    template <class Item, class One>
    static constexpr bool check_kernels(TypeList<>) {
        return true;
    }
    template <class Item, class One, class T, class... Rest>
    static constexpr bool check_kernels(TypeList<T, Rest...>) {
        using Two = typename Listed<T>::Term;
        if constexpr (!requires { typename Two::corrected_kernel; })
            return check_kernels<Item, One>(TypeList<Rest...>{});
        else if constexpr (std::is_void_v<One>)
            return check_kernels<Item, Two>(TypeList<Rest...>{});
        else if constexpr (!std::is_same_v<typename One::corrected_kernel, typename Two::corrected_kernel>)
            return break_rule<rules::TwoKernels<typename One::corrected_kernel, typename Two::corrected_kernel, One,
                                                Two, Item, give_both_the_same_kernel>>();
        else
            return check_kernels<Item, One>(TypeList<Rest...>{});
    }
    // Does a limit on the step take the term's parameters?
    template <class Term, class Parameters, class... M>
    static constexpr bool limit_takes = requires(const M&... m, const TimeStepInput& in, const Parameters& parameters) {
        Term::time_step_limit(m..., in, parameters);
    };
    template <class Term, class Parameters, class M>
    static constexpr bool advection_limit_takes = requires(const M& m, const TimeStepInput& in,
                                                           const Parameters& given) {
        Term::advection_limit(m, in, given);
    };
    template <class Item, class Term, class Parameters>
    static constexpr bool limit_of_item_takes() {
        if constexpr (IsCoupling<Item>)
            return limit_takes<Term, Parameters, typename Item::First, typename Item::Second>;
        else
            return limit_takes<Term, Parameters, Item> || advection_limit_takes<Term, Parameters, Item>;
    }
    // Does a part need parameters that the phase or coupling has not? That is an error of its own.
    template <class Item, class... P>
    static constexpr bool asks_for_others(TypeList<P...>) {
        using Known = Concat<TypeList<void>, typename decltype(Item::coefficients)::List>;
        return (!contains<typename ParametersIn<P>::type, Known> || ...);
    }
    // Are the parameters of a term filled in somewhere? Also in a part that another term brings.
    template <class Item, class Term, class... T>
    static constexpr bool check_parameters(TypeList<T...>) {
        if constexpr (requires { typename Term::Parameters; }) {
            using Given = typename Term::Parameters;
            if constexpr (!(fills_a_part<Given, PartList<Term>> || ... ||
                            fills_a_part<Given, PartList<typename Listed<T>::Term>>))
                if constexpr (!limit_of_item_takes<Item, Term, Given>() && !Prepares<Term> &&
                              !TermOf<Term, Item>::says_support && !asks_for_others<Item>(PartList<Term>{}))
                    return break_rule<rules::ParametersNotTaken<
                        Given, Term, give_the_part_that_uses_them_a_member_of_this_type_named_parameters>>();
        }
        return true;
    }
    template <class Item, class Term>
    static constexpr bool check_prepared() {
        if constexpr (Prepares<Term>)
            if constexpr (!TermOf<Term, Item>::template prepares<2> && !TermOf<Term, Item>::template prepares<3>)
                return break_rule<rules::PreparedByNoFunction<
                    typename Term::Prepared, Term, write_static_Prepared_prepare_of_a_material_or_two_and_a_Lattice>>();
        return true;
    }
    template <class Item, class... T>
    static constexpr bool check_terms(TypeList<T...> list) {
        return (check_term<Item, T>() && ...) && (check_parameters<Item, typename Listed<T>::Term>(list) && ...) &&
               (check_prepared<Item, typename Listed<T>::Term>() && ...) && check_twos<Item>(list) &&
               check_kernels<Item, void>(list);
    }
    // Has a coupling with these terms the term that acts on phase P?
    template <class P, class Term, class... T>
    static constexpr bool has_term_on(TypeList<T...>) {
        return ((acts_on<P, T> && std::is_same_v<typename Listed<T>::Term, Term>) || ...);
    }
    // Has coupling C a term of the same effect on phase P as `Term`, but not what that needs beside it?
    template <class C, class P, class Term>
    static constexpr bool lacks_company() {
        if constexpr (requires { typename Term::beside_in_couplings; })
            return has_effect_on<P, typename Term::effect>(typename C::terms{}) &&
                   !has_term_on<P, typename Term::beside_in_couplings>(typename C::terms{});
        else
            return false;
    }
    template <class C, class P, class Term>
    static constexpr bool is_spoiled() {
        if constexpr (requires { typename Term::never_in_couplings; })
            return has_term_on<P, typename Term::never_in_couplings>(typename C::terms{});
        else
            return false;
    }
    template <class C, class P>
    static constexpr bool check_all_beside(TypeList<>) {
        return true;
    }
    template <class C, class P, class Term, class... Rest>
    static constexpr bool check_all_beside(TypeList<Term, Rest...>) {
        if constexpr (lacks_company<C, P, Term>())
            return break_rule<rules::MissingInCoupling<typename Term::beside_in_couplings, Term, P, C,
                                                       list_it_in_the_coupling_Into_the_phase>>();
        else if constexpr (is_spoiled<C, P, Term>())
            return break_rule<
                rules::NeverInCoupling<typename Term::never_in_couplings, Term, P, C, remove_one_of_the_two_terms>>();
        else
            return check_all_beside<C, P>(TypeList<Rest...>{});
    }
    template <class C>
    static constexpr bool check_company() {
        if constexpr (IsCoupling<C>)
            return check_all_beside<C, typename C::First>(typename C::First::terms{}) &&
                   check_all_beside<C, typename C::Second>(typename C::Second::terms{});
        else
            return true;
    }
};

} // namespace imbibe::detail
