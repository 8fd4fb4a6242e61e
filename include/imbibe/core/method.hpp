// Methods: one name for terms that usually go together, and for how a fluid with these terms meets walls and solids.
//
//   struct Water : imbibe::Fluid<imbibe::Tait<7>, imbibe::WeaklyCompressible<>, imbibe::MonaghanViscosity<>> {};
//   struct Sides : imbibe::CouplingOf<Water, Tank> {};
//
// A method stands in a list like a term and is replaced by its terms, in their order. The rest of the library does not
// know of methods.
#pragma once

#include <imbibe/core/field.hpp>
#include <imbibe/core/rule.hpp>

#include <type_traits>

namespace imbibe {

/// A list of terms with a name: `template <class K> struct WeaklyCompressible : Method<VolumeContinuity<K>, ...> {};`
///
/// Optional, in a method of a fluid: what acts between such a fluid and a wall or solid, for CouplingOf:
/// `template <class Liquid, class Body> using coupling = TypeList<...>;`
template <class... Terms>
struct Method {
    /// The terms, or other methods.
    using stands_for = TypeList<Terms...>;
};

/// In a list of terms: replaces `Old` by `New`, wherever the list or one of its methods has it. Without `New` the term
/// is left out: `Fluid<LinearState, WeaklyCompressible<K>, Instead<DensityFloor>>`. In a coupling the new terms act on
/// the same phases as the old one.
template <class Old, class... New>
struct Instead {};

/// In a coupling: a term that acts on phase P only, with the other phase as neighbours. A term without this
/// wrapper acts on both.
template <class P, class Term>
struct Into {};

struct list_the_term_itself_or_the_method_that_has_it;
struct list_the_terms_in_a_Coupling;
namespace rules {
/// Rule: what is replaced is in the list.
template <class Old, class Advice>
struct NothingToReplace {
    static_assert(sizeof(Old*) == 0, "imbibe: Instead<Old, ...> stands in a list without Old");
};
/// Rule: the first phase of a CouplingOf lists a method that says what acts between it and the other phase.
template <class Liquid, class Body, class Advice>
struct NoMethodOfTheCoupling {
    static_assert(sizeof(Liquid*) == 0,
                  "imbibe: no method of the first phase of this CouplingOf says what acts between the two");
};
} // namespace rules

namespace detail {

// An entry in the list of a phase or coupling: a term, and the phase on which it acts (void: both sides).
template <class T>
struct Listed {
    using Term = T;
    using On = void;
    template <class U>
    using With = U; ///< another term in its place
};
template <class P, class T>
struct Listed<Into<P, T>> {
    using Term = T;
    using On = P;
    template <class U>
    using With = Into<P, U>;
};

template <class T>
concept IsMethod = requires {
    typename Listed<T>::Term::stands_for;
};
template <class T>
inline constexpr bool is_replacement = false;
template <class... T>
inline constexpr bool is_replacement<Instead<T...>> = true;

// The terms that an entry of a list stands for.
template <class T>
struct Expanded {
    using type = TypeList<T>;
};
template <class T, class List>
struct ExpandedAs; // the list's entries where T stands
template <class T, class... M>
struct ExpandedAs<T, TypeList<M...>> {
    using type = Concat<typename Expanded<typename Listed<T>::template With<M>>::type...>;
};
template <IsMethod T>
struct Expanded<T> : ExpandedAs<T, typename Listed<T>::Term::stands_for> {};

// The list with a replacement carried out.
template <class List, class Replacement>
struct Replaced;
template <class... T, class Old, class... New>
struct Replaced<TypeList<T...>, Instead<Old, New...>> {
    static constexpr bool is_there = [] {
        if constexpr (!(std::is_same_v<typename Listed<T>::Term, Old> || ...))
            return break_rule<rules::NothingToReplace<Old, list_the_term_itself_or_the_method_that_has_it>>();
        else
            return true;
    }();
    using type =
        std::conditional_t<is_there,
                           Concat<typename std::conditional_t<std::is_same_v<typename Listed<T>::Term, Old>,
                                                              ExpandedAs<T, TypeList<New...>>, Expanded<T>>::type...>,
                           TypeList<T...>>;
};
template <class List, class... Replacements>
struct ReplacedAll {
    using type = List;
};
template <class List, class First, class... Rest>
struct ReplacedAll<List, First, Rest...> : ReplacedAll<typename Replaced<List, First>::type, Rest...> {};

// The terms of a phase or coupling: its list without methods and replacements.
template <class List, class Replacements>
struct TermsOf;
template <class... T, class... R>
struct TermsOf<TypeList<T...>, TypeList<R...>> : ReplacedAll<Concat<typename Expanded<T>::type...>, R...> {};
template <class... T>
struct TermsIn : TermsOf<Concat<std::conditional_t<is_replacement<T>, TypeList<>, TypeList<T>>...>,
                         Concat<std::conditional_t<is_replacement<T>, TypeList<T>, TypeList<>>...>> {};
template <class... T>
requires(!(IsMethod<T> || ...) && !(is_replacement<T> || ...)) struct TermsIn<T...> {
    using type = TypeList<T...>;
};

// What the methods in a list say of the coupling of A and B.
template <class M, class A, class B>
struct CouplingByMethod {
    using type = TypeList<>;
};
template <class M, class A, class B>
requires requires {
    typename M::template coupling<A, B>;
}
struct CouplingByMethod<M, A, B> {
    using type = typename M::template coupling<A, B>;
};
template <class A, class B, class Written>
struct CouplingByMethods;
template <class A, class B, class... M>
struct CouplingByMethods<A, B, TypeList<M...>> {
    using Found = Concat<typename CouplingByMethod<M, A, B>::type...>;
    static constexpr bool is_there = [] {
        if constexpr (Found::size == 0)
            return break_rule<rules::NoMethodOfTheCoupling<A, B, list_the_terms_in_a_Coupling>>();
        else
            return true;
    }();
    using type = std::conditional_t<is_there, Found, TypeList<>>;
};

} // namespace detail

} // namespace imbibe
