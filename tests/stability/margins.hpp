// What the gauntlet's tests ask of a case: it is stable at the CFL number that it is offered with and a quarter beyond,
// and steps that are too long are noticed and named.
#pragma once

#include <catch_shim.hpp>

#include <cases/stability/march.hpp>

#include <imbibe/presets/sponge_case.hpp>
#include <imbibe/solver/settings.hpp>

namespace gauntlet {

using stability::Outcome;
using stability::Plan;

inline std::string words(const Outcome& out) {
    std::string all = out.message + " [" + std::to_string(out.steps) + " steps, limited by " + out.limit + "]";
    for (const auto& sign : out.signs)
        all += "; " + sign.name + " " + std::to_string(sign.worst);
    return all;
}
inline void check_stable(const auto& run, double cfl, double value) {
    const Outcome out = run(Plan{.cfl = cfl, .value = value});
    CAPTURE(cfl, value);
    INFO(words(out));
    CHECK(out.stable);
}
/// Stable at the default CFL number and a quarter above it.
template <class Run>
void check_margin(const Run& run, double value = 0) {
    const double offered = imbibe::Settings<2>{}.cfl;
    for (const double cfl : {offered, 1.25 * offered})
        check_stable(run, cfl, value);
}
/// The same for what the sponge's preset is made of, and at the preset's CFL number and a quarter above that.
template <class Run>
void check_preset(const Run& run, double value = 0) {
    const double offered = imbibe::presets::SpongeCase{}.cfl;
    for (const double cfl : {0.4, offered, 1.25 * offered})
        check_stable(run, cfl, value);
}
/// The same in space, where an eighth more is borne: water that is thrown about with all its damping comes to an edge
/// at 0.86 there, at 0.94 in the plane.
template <class Run>
void check_preset_in_space(const Run& run, double value = 0) {
    const double offered = imbibe::presets::SpongeCase{}.cfl;
    for (const double cfl : {0.4, offered, 1.125 * offered})
        check_stable(run, cfl, value);
}
/// Steps of 2, 5 and 20 times the limit are noticed, and the reason is given. Row 13.
template <class Run>
void check_noticed(const Run& run, double value = 0) {
    for (const double cfl : {2.0, 5.0, 20.0}) {
        const Outcome out = run(Plan{.cfl = cfl, .value = value});
        CAPTURE(cfl, value);
        INFO(words(out));
        CHECK(!out.stable);
        CHECK(out.steps < 400);
        CHECK_THAT(out.message, imbibe_test::contains(" times the limit of "));
    }
}

} // namespace gauntlet
