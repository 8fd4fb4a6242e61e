// What the gauntlet's tests ask of a case: it is stable a quarter beyond the default CFL number, and steps that are far
// too long are noticed and named.
#pragma once

#include <catch_shim.hpp>

#include "stability/march.hpp"

namespace gauntlet {

using stability::Outcome;
using stability::Plan;

inline std::string words(const Outcome& out) {
    std::string all = out.message + " [" + std::to_string(out.steps) + " steps, limited by " + out.limit + "]";
    for (const auto& sign : out.signs)
        all += "; " + sign.name + " " + std::to_string(sign.worst);
    return all;
}
/// Stable at the default CFL number and a quarter above it.
template <class Run>
void check_margin(const Run& run, double value = 0) {
    for (const double cfl : {0.4, 0.5}) {
        const Outcome out = run(Plan{.cfl = cfl, .value = value});
        CAPTURE(cfl, value);
        INFO(words(out));
        CHECK(out.stable);
    }
}
/// Steps of 5 and 20 times the limit are noticed, and the reason is given. Row 13.
template <class Run>
void check_noticed(const Run& run, double value = 0) {
    for (const double cfl : {5.0, 20.0}) {
        const Outcome out = run(Plan{.cfl = cfl, .value = value});
        CAPTURE(cfl, value);
        INFO(words(out));
        CHECK(!out.stable);
        CHECK(out.steps < 200);
        CHECK_THAT(out.message, imbibe_test::contains("step"));
        CHECK_THAT(out.message, imbibe_test::contains("limit"));
    }
}

} // namespace gauntlet
