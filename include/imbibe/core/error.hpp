// The one exception type of the library, and the small helper that writes its messages.
#pragma once

#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

// With finite-math options the compiler takes every number for finite and drops the checks for NaN: NaN in a scene, and
// memory addresses computed from it, would go unnoticed.
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "imbibe: -ffast-math and -Ofast drop the checks for NaN; add -fno-finite-math-only or leave them out"
#endif

namespace imbibe {

/// Thrown for bad input and for runs that go wrong. The message names the value, its unit, the allowed range
/// and the remedy.
class Error : public std::runtime_error {
public:
    /// The message. Flushes the standard output, from any thread: if the error is not caught, the program ends without
    /// flushing, and what the run has printed into a file or pipe, which shows how far it got, would be lost.
    explicit Error(const std::string& message) : std::runtime_error(message) { std::fflush(stdout); }
};

namespace detail {

/// A part of a text: a pointer to it, and how a stream prints it. The code that joins parts is compiled once, not once
/// for every list of types.
class TextPart {
public:
    TextPart(std::string_view words) : words_(words) {}
    TextPart(const char* words) : words_(words) {}
    TextPart(const std::string& words) : words_(words) {}
    /// Anything that a stream prints.
    template <class T>
    TextPart(const T& value)
        : value_(&value), print_([](std::ostream& out, const void* where) { out << *static_cast<const T*>(where); }) {}

    friend std::ostream& operator<<(std::ostream& out, const TextPart& part) {
        if (part.print_ == nullptr)
            return out << part.words_;
        part.print_(out, part.value_);
        return out;
    }

private:
    std::string_view words_;
    const void* value_ = nullptr;
    void (*print_)(std::ostream&, const void*) = nullptr;
};

[[gnu::cold, gnu::noinline]] inline std::string joined(std::initializer_list<TextPart> parts) {
    std::ostringstream out;
    out.imbue(std::locale::classic()); // a host's locale may write commas for points
    out.precision(6);
    for (const TextPart& part : parts)
        out << part;
    return out.str();
}
[[noreturn, gnu::cold, gnu::noinline]] inline void refuse(std::initializer_list<TextPart> parts) {
    throw Error(joined(parts));
}

} // namespace detail

/// Concatenates its arguments as an output stream would print them: the text of an Error.
template <class... Parts>
[[nodiscard]] std::string text(const Parts&... parts) {
    return detail::joined({parts...});
}

/// Throws Error with the concatenated parts unless `condition` holds.
template <class... Parts>
void require(bool condition, const Parts&... parts) {
    if (!condition)
        detail::refuse({parts...});
}

/// Throws Error unless `value` is a finite number not below 0.
/// @param value the number
/// @param where the phase or coupling it belongs to
/// @param name what it is called there
/// @param unit its unit, empty for a pure number
inline void require_not_negative(double value, std::string_view where, std::string_view name, std::string_view unit) {
    const std::string measured = unit.empty() ? std::string() : text(" ", unit);
    require(std::isfinite(value) && value >= 0, where, ": ", name, " = ", value, measured,
            "; it must be a finite number not below 0", measured);
}

} // namespace imbibe
