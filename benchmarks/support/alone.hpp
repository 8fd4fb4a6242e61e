// One pair part of a term alone in a scene: what it reads of what other terms would set is set once, before the first
// step, so that the loops of a step are its sweep and nothing else.
#pragma once

#include <imbibe/core/phase.hpp>

#include <utility>

namespace imbibe::bench {

/// Sets a field once, to numbers that no formula stumbles over: 1, tensors near the identity.
template <class Field>
struct Once {
    static constexpr bool once = true;
    using reads = Fields<mass>;
    using sets = TypeList<Field>;

    IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
        using A = std::remove_cvref_t<decltype(a)>;
        using T = typename A::Scalar;
        const T one = T(1) + T(0) * a[mass];
        Value<Field, A::dimension, T> v{};
        for (int k = 0; k < components(Field::rank, A::dimension); ++k)
            component(v, k) = T(0.1) * one;
        if constexpr (Field::rank == Rank::scalar)
            v = one;
        else if constexpr (Field::rank != Rank::vector)
            for (int i = 0; i < A::dimension; ++i)
                v(i, i) = one;
        return v;
    }
};

namespace detail {

template <class Part>
concept HasParameters = requires(Part part) {
    part.parameters;
};

template <class Part>
struct ParametersOf {};
template <HasParameters Part>
struct ParametersOf<Part> {
    using Parameters = decltype(Part::parameters);
};

template <class Part>
struct OnlyPart : ParametersOf<Part> {
    using parts = Parts<Part>;
};

// The fields among `List` that someone else would have to set.
template <class List>
struct Missing;
template <class... F>
struct Missing<TypeList<F...>> {
    using type = imbibe::detail::Concat<std::conditional_t<F::given, TypeList<>, TypeList<F>>...>;
};

template <template <class...> class Phase, class List, class... Terms>
struct With;
template <template <class...> class Phase, class... F, class... Terms>
struct With<Phase, TypeList<F...>, Terms...> {
    using type = Phase<Once<F>..., Terms...>;
};

} // namespace detail

/// A phase, `Fluid`, `Solid` or `Wall`, with nothing but a pair part.
template <template <class...> class Phase, class Part>
using Alone =
    typename detail::With<Phase, typename detail::Missing<typename Part::reads>::type, detail::OnlyPart<Part>>::type;

/// A phase with nothing but the fields that a pair part of a coupling reads.
template <template <class...> class Phase, class Part>
using ReadBy = typename detail::With<Phase, typename detail::Missing<typename Part::reads>::type>::type;

} // namespace imbibe::bench
