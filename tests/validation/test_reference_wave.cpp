// A standing wave, as in benchmarks/validation, coarse; docs/validation.md has it finer.
#include <benchmarks/validation/standing_wave.hpp>
#include <catch_shim.hpp>

namespace wave = validation::standing_wave;

TEST_CASE("A standing wave swings and decays as viscous theory says", "[validation][fluid]") {
    const auto seen = wave::swing(20, 250, 6), exact = wave::exact(250);
    CAPTURE(seen.period, exact.period, seen.rate, exact.rate);
    CHECK(seen.period == Approx(exact.period).epsilon(0.01));
    CHECK(seen.rate == Approx(exact.rate).epsilon(0.05));
}
