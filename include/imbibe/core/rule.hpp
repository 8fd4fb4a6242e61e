// How a broken rule is said: one error, whose text is the rule's and whose names are the culprits. And the rule that
// scenes and shapes share.
#pragma once

#include <type_traits>

namespace imbibe {

namespace rules {
/// Rule: scenes and shapes are those of the plane or of space.
template <class Dimension>
struct NotTwoOrThreeDimensions {
    static_assert(sizeof(Dimension) == 0, "imbibe: a scene or a shape has 2 or 3 dimensions");
};
} // namespace rules

namespace detail {

// Prints the rule's message, once: a class is completed when it is named as a base, and its static_assert fires. It is
// not touched again, so that neither compiler has a second complaint. False, for checks that end there.
template <class Rule>
constexpr bool break_rule() {
    struct Broken : Rule {};
    return false;
}

// What a function returns behind a broken rule, so that nothing else is wrong with it. There is none.
template <class T>
T& nothing();

// True, or a compile error that names the broken rule.
template <int dim>
constexpr bool check_dimension() {
    if constexpr (dim != 2 && dim != 3)
        return break_rule<rules::NotTwoOrThreeDimensions<std::integral_constant<int, dim>>>();
    else
        return true;
}

} // namespace detail

} // namespace imbibe
