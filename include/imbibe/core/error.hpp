// The one exception type of the library, and the small helper that writes its messages.
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

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

} // namespace imbibe
