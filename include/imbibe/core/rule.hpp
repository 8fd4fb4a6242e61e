// How a broken rule is said: one error, whose text is the rule's and whose names are the culprits.
#pragma once

namespace imbibe::detail {

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

} // namespace imbibe::detail
