// The numbers of a small struct, such as the coefficients of a term, as text: to compare two such structs and to report
// how they differ, without a function in the struct.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/number_in_text.hpp>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>

namespace imbibe::detail {

/// A number as text that reads back as the same number, as short as possible.
inline std::string exact_text(double value) {
    const std::string brief = text(value);
    if (const auto read = number_in_text(brief); !read || read->value == value)
        return brief; // infinities and NaN do not read back
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(17);
    out << value;
    return out.str();
}

/// Converts to any number: tests how many numbers a struct can be made of.
struct AnyNumber {
    template <class T>
    requires std::is_arithmetic_v<T>
    constexpr operator T() const { return T(); }
};
template <std::size_t>
using AnyNumberAt = AnyNumber;

/// Can a T be made of this many numbers?
template <class T, std::size_t... k>
constexpr bool takes_numbers(std::index_sequence<k...>) {
    return requires {
        T{AnyNumberAt<k>{}...};
    };
}
/// Is one of its members an array, which takes several numbers of these?
template <class T, std::size_t... k>
constexpr bool takes_two_at_once(std::index_sequence<k...>) {
    return requires {
        T{AnyNumberAt<k>{}..., {AnyNumber{}, AnyNumber{}}};
    };
}
template <class T, std::size_t... k>
constexpr bool has_array(std::index_sequence<k...>) {
    return (takes_two_at_once<T>(std::make_index_sequence<k>{}) || ...);
}
/// The number of members of a struct of numbers only; 0 for any other type, and for more than eight.
template <class T>
constexpr std::size_t count_of_numbers() {
    if constexpr (std::is_aggregate_v<T>) {
        std::size_t most = 0;
        [&]<std::size_t... n>(std::index_sequence<n...>) {
            ((most = takes_numbers<T>(std::make_index_sequence<n + 1>{}) ? n + 1 : most), ...);
        }
        (std::make_index_sequence<9>{});
        return most > 8 || has_array<T>(std::make_index_sequence<9>{}) ? 0 : most;
    } else {
        return 0;
    }
}

/// "0.1, 2": the members of a struct of at most eight numbers only; empty for any other type.
template <class T>
std::string numbers_of(const T& all) {
    constexpr std::size_t count = count_of_numbers<T>();
    const auto list = [](const auto&... number) {
        std::string words;
        ((words += (words.empty() ? "" : ", ") + exact_text(static_cast<double>(number))), ...);
        return words;
    };
    if constexpr (count == 1) {
        const auto& [a] = all;
        return list(a);
    } else if constexpr (count == 2) {
        const auto& [a, b] = all;
        return list(a, b);
    } else if constexpr (count == 3) {
        const auto& [a, b, c] = all;
        return list(a, b, c);
    } else if constexpr (count == 4) {
        const auto& [a, b, c, d] = all;
        return list(a, b, c, d);
    } else if constexpr (count == 5) {
        const auto& [a, b, c, d, e] = all;
        return list(a, b, c, d, e);
    } else if constexpr (count == 6) {
        const auto& [a, b, c, d, e, f] = all;
        return list(a, b, c, d, e, f);
    } else if constexpr (count == 7) {
        const auto& [a, b, c, d, e, f, g] = all;
        return list(a, b, c, d, e, f, g);
    } else if constexpr (count == 8) {
        const auto& [a, b, c, d, e, f, g, h] = all;
        return list(a, b, c, d, e, f, g, h);
    } else {
        return {};
    }
}

} // namespace imbibe::detail
