// A million steps at rest: does anything creep in? Row 20 of the gauntlet.
#include "margins.hpp"
#include "stability/fluids.hpp"

TEST_CASE("Still water stays still for a million steps", "[stability]") {
    const auto out = stability::still_water<stability::WeaklyCompressible>({.cfl = 0.4, .value = 1800});
    INFO(gauntlet::words(out));
    CHECK(out.steps > 1'000'000);
    CHECK(out.stable);
}
