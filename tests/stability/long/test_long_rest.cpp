// A million steps at rest: does anything creep in? Row 20 of the gauntlet.
#include "margins.hpp"
#include <cases/stability/fluids.hpp>

TEST_CASE("Still water stays still for a million steps, in float too", "[stability]") {
    const auto check = []<class Real>(Real) {
        stability::Rest rest;
        const auto out =
            stability::settling_water<stability::WeaklyCompressible, Real>({.cfl = 0.4, .value = 2900}, rest);
        INFO(gauntlet::words(out));
        CHECK(out.steps > 1'000'000);
        CHECK(out.stable);
        return rest;
    };
    const auto rest = check(double{});
    CHECK(rest.last_tenth > 0);
    CHECK(rest.last_tenth / rest.fifth_tenth < 1);
    // In float the fifth tenth is long since down to what rounding gives, a ten-millionth, and both wander about it.
    const auto rounded = check(float{});
    CHECK(rounded.last_tenth > 0);
    CHECK(rounded.last_tenth / 1e-7 < 1);
    CHECK(rounded.last_tenth / rounded.fifth_tenth < 2);
}
