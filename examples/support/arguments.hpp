// The numbers that a program is given behind its name.
#pragma once

#include <imbibe/core/error.hpp>

#include <cstdlib>

namespace imbibe::example {

/// The number at a place of the command line, the first at 1; `otherwise` where none is given. Throws Error, which
/// names it and its bounds, for what is no number or not from `low` to `high`.
inline double number(char** argv, int place, const char* name, double otherwise, double low, double high) {
    for (int k = 0; k <= place; ++k)
        if (argv[k] == nullptr)
            return otherwise;
    char* end = nullptr;
    const double value = std::strtod(argv[place], &end);
    require(end != argv[place] && *end == '\0' && value >= low && value <= high, name, ", '", argv[place],
            "', must be a number from ", low, " to ", high);
    return value;
}

} // namespace imbibe::example
