// How a broken rule is reported: one compile error, whose text is the rule's and whose names are the culprits. And the
// rule that scenes and shapes share.
#pragma once

#include <type_traits>

namespace imbibe {

namespace rules {
/// Rule: scenes and shapes have two or three dimensions.
template <class Dimension>
struct NotTwoOrThreeDimensions {
    static_assert(sizeof(Dimension) == 0, "imbibe: a scene or a shape has 2 or 3 dimensions");
};
} // namespace rules

namespace detail {

// Prints the rule's message, once: naming a class as a base completes it, and its static_assert fires. It is not used
// again, so neither compiler reports a second error. False, for checks that end there.
template <class Rule>
constexpr bool break_rule() {
    struct Broken : Rule {};
    return false;
}

// The return type of a function after a broken rule, so that it causes no further error. It has no definition.
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
