// What a field is: a name, a unit and a rank; and lists of fields, in which terms say what they read, add to and set.
#pragma once

#include <imbibe/core/vector.hpp>

#include <array>
#include <string_view>
#include <type_traits>

namespace imbibe {

/// What a field holds per particle.
enum class Rank { scalar, vector, symmetric_tensor, tensor };

/// Base of every field. A field is an empty struct with `name` and `unit`, and one constant of it; one that is integrated
/// has `rate_name` and `rate_unit` as well, those of its Rate:
/// <!-- examples/guides/heat.cpp -->
/// ```
/// struct Temperature : sph::Field<sph::Rank::scalar> {
///     static constexpr std::string_view name = "temperature", unit = "K";
///     static constexpr std::string_view rate_name = "temperature_rate", rate_unit = "K/s";
/// };
/// inline constexpr Temperature temperature{};
/// ```
/// `given` says whether the solver gives the field a value when particles are added. All others must be set by a term,
/// or be integrated from a rate (these start from zero).
template <Rank r>
struct Field {
    /// What it holds per particle.
    static constexpr Rank rank = r;
    static constexpr bool given = false;
    /// Is it written to output files? States (fields that are given or integrated) always are.
    static constexpr bool shown = false;
};

/// The rate of change of a field in time. A field to whose rate some term adds is integrated by the solver.
template <class F>
struct Rate : Field<F::rank> {
    /// The field whose rate it is.
    using State = F;
    static constexpr std::string_view name = F::rate_name;
    static constexpr std::string_view unit = F::rate_unit;
};

/// How many numbers a field of this rank has per particle in `dim` dimensions.
constexpr int components(Rank rank, int dim) {
    switch (rank) {
    case Rank::scalar:
        return 1;
    case Rank::vector:
        return dim;
    case Rank::symmetric_tensor:
        return dim * (dim + 1) / 2;
    default:
        return dim * dim;
    }
}

namespace detail {
template <Rank rank, int dim, class T>
struct ValueOf {
    using type = T;
};
template <int dim, class T>
struct ValueOf<Rank::vector, dim, T> {
    using type = Vector<T, dim>;
};
template <int dim, class T>
struct ValueOf<Rank::symmetric_tensor, dim, T> {
    using type = SymmetricTensor<T, dim>;
};
template <int dim, class T>
struct ValueOf<Rank::tensor, dim, T> {
    using type = Tensor<T, dim>;
};
} // namespace detail

/// The type of one particle's value of field F: T, Vector<T, dim>, SymmetricTensor<T, dim> or Tensor<T, dim>.
template <class F, int dim, class T>
using Value = typename detail::ValueOf<F::rank, dim, T>::type;

/// Component k of a value of any rank.
template <class T>
IMBIBE_INLINE constexpr auto& component(T& value, [[maybe_unused]] int k) {
    if constexpr (detail::Algebraic<T>)
        return value.c[k];
    else
        return value;
}

/// A list of types.
template <class... T>
struct TypeList {
    /// How many types.
    static constexpr int size = sizeof...(T);
};

namespace detail {

template <class T, class List>
inline constexpr bool contains = false;
template <class T, class... U>
inline constexpr bool contains<T, TypeList<U...>> = (std::is_same_v<T, U> || ...);

/// The position of T in the list; the list's size where it is not in it.
template <class T, class List>
inline constexpr int index_of = 0;
template <class T, class... U>
inline constexpr int index_of<T, TypeList<U...>> = [] {
    constexpr bool same[] = {std::is_same_v<T, U>..., true};
    int k = 0;
    while (!same[k])
        ++k;
    return k;
}();

template <class... Lists>
struct ConcatImpl {
    using type = TypeList<>;
};
template <class... A>
struct ConcatImpl<TypeList<A...>> {
    using type = TypeList<A...>;
};
template <class... A, class... B, class... Rest>
struct ConcatImpl<TypeList<A...>, TypeList<B...>, Rest...> : ConcatImpl<TypeList<A..., B...>, Rest...> {};
template <class... Lists>
using Concat = typename ConcatImpl<Lists...>::type;

template <class Done, class... T>
struct UniqueImpl {
    using type = Done;
};
template <class... Done, class T, class... Rest>
struct UniqueImpl<TypeList<Done...>, T, Rest...>
    : UniqueImpl<std::conditional_t<(std::is_same_v<T, Done> || ...), TypeList<Done...>, TypeList<Done..., T>>,
                 Rest...> {};
template <class List>
struct UniqueOf;
template <class... T>
struct UniqueOf<TypeList<T...>> : UniqueImpl<TypeList<>, T...> {};
/// The list without repetitions, in the order of first appearance.
template <class List>
using Unique = typename UniqueOf<List>::type;

template <int k, class List>
struct AtImpl;
template <class T, class... Rest>
struct AtImpl<0, TypeList<T, Rest...>> {
    using type = T;
};
template <int k, class T, class... Rest>
struct AtImpl<k, TypeList<T, Rest...>> : AtImpl<k - 1, TypeList<Rest...>> {};
template <int k, class List>
using At = typename AtImpl<k, List>::type;

} // namespace detail

/// A list of fields by their constants: `using reads = Fields<density, pressure>;`
template <auto... field>
using Fields = TypeList<std::remove_cvref_t<decltype(field)>...>;

} // namespace imbibe
