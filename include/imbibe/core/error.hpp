// The one exception type of the library, and the small helper that writes its messages.
#pragma once

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace imbibe {

/// Thrown for bad input and for runs that go wrong. The message names the value, its unit, the allowed range
/// and the remedy.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Concatenates its arguments as an output stream would print them: the text of an Error.
template <class... Parts>
[[nodiscard]] std::string text(const Parts&... parts) {
    std::ostringstream out;
    out.precision(6);
    (out << ... << parts);
    return out.str();
}

/// Throws Error with the concatenated parts unless `condition` holds.
template <class... Parts>
void require(bool condition, const Parts&... parts) {
    if (!condition)
        throw Error(text(parts...));
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
