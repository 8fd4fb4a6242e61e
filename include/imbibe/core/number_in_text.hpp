// Reads a number from a text in the library's own format, with a decimal point in every locale.
#pragma once

#include <ios>
#include <locale>
#include <optional>
#include <sstream>
#include <string>

namespace imbibe::detail {

/// The number that a text begins with.
struct NumberInText {
    double value; ///< the number
    bool is_all;  ///< is there nothing behind it?
};

/// The number that `words` begin with, if they begin with one. (Not by std::from_chars: before LLVM 20 clang's own
/// standard library has it for whole numbers only.)
inline std::optional<NumberInText> number_in_text(const std::string& words) {
    std::istringstream in(words);
    in.imbue(std::locale::classic());
    double value = 0;
    if (!(in >> std::noskipws >> value))
        return std::nullopt;
    return NumberInText{value, in.peek() == std::istringstream::traits_type::eof()};
}

} // namespace imbibe::detail
