// From phases and couplings to nodes: every part of every term on every phase it acts on, and the fields that each
// phase needs for them. All of it is types; nothing here exists at run time.
#pragma once

#include <imbibe/core/dry_run.hpp>
#include <imbibe/core/phase.hpp>

namespace imbibe::detail {

template <class T>
concept IsCoupling = requires {
    typename T::First;
    typename T::Second;
    typename T::terms;
};
template <class T>
concept IsPhase = !IsCoupling<T> && requires {
    typename T::terms;
    T::moves;
    typename T::motion;
};

/// A coupling of two phases; anything else gives nothing.
template <class T>
concept CouplesPhases = IsCoupling<T> && IsPhase<typename T::First> && IsPhase<typename T::Second>;

/// The reach of a term with a support radius of its own, with the coefficients of Owner, a phase or a coupling.
template <class Term_, class Owner_>
struct OwnSupport {
    using Term = Term_;
    using Owner = Owner_;
};

/// Part P on phase A, with neighbours of phase B (A itself inside a phase), its coefficients kept by Owner.
template <class P, class A_, class B_, class Owner_, class Term_>
struct Node {
    using Part = P;
    using A = A_;
    using B = B_;
    using Owner = Owner_;
    using Term = Term_;
    using Reads = typename ReadsOf<P>::type;
    using Adds = typename AddsOf<P>::type;
    using Sets = typename SetsOf<P>::type;
    static constexpr bool reference = uses_reference<P>;
    /// The type that gives its reach; void: the phases'.
    using Reach = std::conditional_t<TermOf<Term, Owner>::says_support, OwnSupport<Term, Owner>, void>;
    static constexpr bool once = is_once<P>;
    static constexpr bool in_packs = is_in_packs<P>;
};

/// A node that advances state F of phase P by its rate.
template <class P, class F>
struct Advance {
    using A = P;
    using B = P;
    using Field = F;
    using Term = Advance;
    static constexpr bool once = false;
};
template <class N>
inline constexpr bool is_advance = false;
template <class P, class F>
inline constexpr bool is_advance<Advance<P, F>> = true;

// ---- the phases a coupling names --------------------------------------------------------------------------------

template <class Term>
struct TargetOf {
    using type = TypeList<>;
};
template <class P, class Term>
struct TargetOf<Into<P, Term>> {
    using type = TypeList<P>;
};
/// The phases into which a coupling sends terms.
template <class Terms>
struct TargetsOf;
template <class... Term>
struct TargetsOf<TypeList<Term...>> {
    using type = Concat<typename TargetOf<Term>::type...>;
};
template <class Couplings>
struct PhasesNamed;
template <class... C>
struct PhasesNamed<TypeList<C...>> {
    using type =
        Concat<TypeList<typename C::First, typename C::Second>..., typename TargetsOf<typename C::terms>::type...>;
};

// ---- filters ------------------------------------------------------------------------------------------------------

template <template <class> class Keep, class List>
struct FilterImpl;
template <template <class> class Keep, class... T>
struct FilterImpl<Keep, TypeList<T...>> {
    using type = Concat<std::conditional_t<Keep<T>::value, TypeList<T>, TypeList<>>...>;
};
template <template <class> class Keep, class List>
using Filter = typename FilterImpl<Keep, List>::type;

template <class T>
struct KeepPhases : std::bool_constant<IsPhase<T>> {};
template <class T>
struct KeepCouplings : std::bool_constant<CouplesPhases<T>> {};

// A sum into the acceleration of a phase that does not move is skipped.
template <class N>
struct KeepUseful : std::bool_constant<N::A::moves || !std::is_same_v<typename N::Adds, Fields<acceleration>>> {};

/// Can the term belong to phase P? One that needs elastic moduli only if P has them.
template <class P, class Term>
inline constexpr bool suits = true;
template <class P, class Term>
    requires requires { Term::of_solids; }
inline constexpr bool suits<P, Term> = requires(const P& p) { p.shear_modulus; };
template <class P, class Term>
using PartsOn = std::conditional_t<suits<P, Term>, PartList<Term>, TypeList<>>;

// ---- nodes --------------------------------------------------------------------------------------------------------

template <class A, class B, class Owner, class Term, class Parts>
struct NodesOfParts;
template <class A, class B, class Owner, class Term, class... P>
struct NodesOfParts<A, B, Owner, Term, TypeList<P...>> {
    using type = TypeList<Node<P, A, B, Owner, Term>...>;
};

template <class P, class Terms>
struct NodesOfPhase;
template <class P, class... Term>
struct NodesOfPhase<P, TypeList<Term...>> {
    using type = Concat<typename NodesOfParts<P, P, P, Term, PartsOn<P, Term>>::type...>;
};

template <class C, class Term>
struct NodesOfCouplingTerm { // acts on both
    using type = Concat<typename NodesOfParts<typename C::First, typename C::Second, C, Term, PartList<Term>>::type,
                        typename NodesOfParts<typename C::Second, typename C::First, C, Term, PartList<Term>>::type>;
};
template <class C, class P, class Term>
struct NodesOfCouplingTerm<C, Into<P, Term>> {
    using Other = std::conditional_t<std::is_same_v<P, typename C::First>, typename C::Second, typename C::First>;
    using Parts = std::conditional_t<IsPhase<P>, PartList<Term>, TypeList<>>; // or else an error of its own
    using type = typename NodesOfParts<P, Other, C, Term, Parts>::type;
};
template <class C, class Terms>
struct NodesOfCoupling;
template <class C, class... Term>
struct NodesOfCoupling<C, TypeList<Term...>> {
    using type = Concat<typename NodesOfCouplingTerm<C, Term>::type...>;
};

// The same particle part on the same phase runs once for all terms that need it, with the first one's coefficients. So
// does the same sum over the same neighbours, for the terms of one phase or coupling.
template <int dim, class N>
inline constexpr bool is_pair_node = is_pair_part<typename N::Part, dim, typename N::A, typename N::B>;

template <int dim, class Kept, class... Rest>
struct MergeImpl {
    using type = Kept;
};
template <int dim, class N, class... K>
consteval bool already_there(TypeList<K...>) {
    if constexpr (is_pair_node<dim, N>)
        return ((std::is_same_v<typename N::Part, typename K::Part> && std::is_same_v<typename N::A, typename K::A> &&
                 std::is_same_v<typename N::B, typename K::B> && std::is_same_v<typename N::Owner, typename K::Owner> &&
                 std::is_same_v<typename N::Reach, typename K::Reach>) ||
                ...);
    else
        return ((std::is_same_v<typename N::Part, typename K::Part> && std::is_same_v<typename N::A, typename K::A>) ||
                ...);
}
template <int dim, class... K, class N, class... Rest>
struct MergeImpl<dim, TypeList<K...>, N, Rest...>
    : MergeImpl<dim, std::conditional_t<already_there<dim, N>(TypeList<K...>{}), TypeList<K...>, TypeList<K..., N>>,
                Rest...> {};
template <int dim, class List>
struct MergeOf;
template <int dim, class... N>
struct MergeOf<dim, TypeList<N...>> : MergeImpl<dim, TypeList<>, N...> {};

template <int dim, class Phases, class Couplings>
struct CollectNodes;
template <int dim, class... P, class... C>
struct CollectNodes<dim, TypeList<P...>, TypeList<C...>> {
    using type =
        typename MergeOf<dim,
                         Filter<KeepUseful, Concat<typename NodesOfPhase<P, typename P::terms>::type...,
                                                   typename NodesOfCoupling<C, typename C::terms>::type...>>>::type;
};

// ---- reductions ---------------------------------------------------------------------------------------------------

template <class P, class Terms>
struct ReductionsOfPhase;
template <class P, class... Term>
struct ReductionsOfPhase<P, TypeList<Term...>> {
    template <class One>
    using Own = std::conditional_t<suits<P, One>, typename ReductionsOf<One>::type, TypeList<>>;
    using type = Concat<typename NodesOfParts<P, P, P, Term, Own<Term>>::type...>;
};
/// The reductions of the terms of all phases, each as the node of a part.
template <class Phases>
struct CollectReductions;
template <class... P>
struct CollectReductions<TypeList<P...>> {
    using type = Concat<typename ReductionsOfPhase<P, typename P::terms>::type...>;
};

// ---- the fields of a phase ----------------------------------------------------------------------------------------

template <int dim, class N, class Side, class List>
struct ReadsOnSide; // Side: true_type for a, false_type for b
template <int dim, class N, class Side, class... F>
struct ReadsOnSide<dim, N, Side, TypeList<F...>> {
    template <class X>
    static consteval bool read() {
        constexpr int k = index_of<X, TypeList<F...>>;
        constexpr auto& seen = reads_on<typename N::Part, dim, typename N::A, typename N::B>;
        if constexpr (Side::value)
            return seen.a[k];
        else
            return seen.b[k];
    }
    using type = Concat<std::conditional_t<read<F>(), TypeList<F>, TypeList<>>...>;
};
/// The fields a node reads of its own particle, and of its neighbours.
template <int dim, class N>
using ReadsOnA = typename ReadsOnSide<dim, N, std::true_type, typename N::Reads>::type;
template <int dim, class N>
using ReadsOnB = typename ReadsOnSide<dim, N, std::false_type, typename N::Reads>::type;

template <class List>
struct StatesOfRates;
template <class F>
struct StateOfRate {
    using type = TypeList<>;
};
template <class F>
struct StateOfRate<Rate<F>> {
    using type = TypeList<F>;
};
template <class... F>
struct StatesOfRates<TypeList<F...>> {
    using type = Concat<typename StateOfRate<F>::type...>;
};

template <int dim, class P, class N>
struct FieldsFromNode {
    using OnA =
        Concat<ReadsOnA<dim, N>, typename N::Sets, typename N::Adds, typename StatesOfRates<typename N::Adds>::type,
               std::conditional_t<N::reference, Fields<reference_position>, TypeList<>>>;
    using OnB = Concat<ReadsOnB<dim, N>, std::conditional_t<N::reference, Fields<reference_position>, TypeList<>>>;
    using type = Concat<std::conditional_t<std::is_same_v<P, typename N::A>, OnA, TypeList<>>,
                        std::conditional_t<std::is_same_v<P, typename N::B>, OnB, TypeList<>>>;
};

template <class P, class Terms>
struct StoredByTerms;
template <class P, class... Term>
struct StoredByTerms<P, TypeList<Term...>> {
    using type = Concat<typename StoresOf<Term>::type...>;
};

template <int dim, class P, class Nodes>
struct CollectFields;
template <int dim, class P, class... N>
struct CollectFields<dim, P, TypeList<N...>> {
    // Every phase has a position and a mass; a moving one has a velocity and, if moved by forces, an acceleration.
    using Base =
        std::conditional_t<P::moves, Fields<position, velocity, acceleration, mass>,
                           std::conditional_t<drifts<P>, Fields<position, velocity, mass>, Fields<position, mass>>>;
    using type = Unique<
        Concat<Base, typename StoredByTerms<P, typename P::terms>::type, typename FieldsFromNode<dim, P, N>::type...>>;
};

// ---- columns ------------------------------------------------------------------------------------------------------

/// The first component of field F in the list, counting `components` for each field before it.
template <int dim, class F, class List>
inline constexpr int component_offset = 0;
template <int dim, class F, class... G>
inline constexpr int component_offset<dim, F, TypeList<G...>> = [] {
    constexpr int size[] = {components(G::rank, dim)..., 0};
    int sum = 0;
    for (int k = 0; k < index_of<F, TypeList<G...>>; ++k)
        sum += size[k];
    return sum;
}();
template <int dim, class List>
inline constexpr int component_count = 0;
template <int dim, class... G>
inline constexpr int component_count<dim, TypeList<G...>> = (components(G::rank, dim) + ... + 0);

} // namespace imbibe::detail
