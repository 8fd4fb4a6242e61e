// One include for Catch2 version 2 and version 3, so that the tests read the same with either.
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif

namespace imbibe_test {
#if __has_include(<catch2/catch_all.hpp>)
inline auto contains(const std::string& text) {
    return Catch::Matchers::ContainsSubstring(text);
}
#else
inline auto contains(const std::string& text) {
    return Catch::Matchers::Contains(text);
}
#endif
} // namespace imbibe_test
