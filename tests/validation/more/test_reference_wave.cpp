// A standing wave, as in cases/validation, coarse; docs/validation.md has it finer.
#include <cases/validation/standing_wave.hpp>
#include <catch_shim.hpp>

namespace wave = validation::standing_wave;

TEST_CASE("A standing wave swings and decays as viscous theory says", "[validation][fluid]") {
    const auto seen = wave::swing<wave::Sea>(20, 250, 6), exact = wave::exact(250);
    CAPTURE(seen.period, exact.period, seen.rate, exact.rate);
    CHECK(seen.period == Approx(exact.period).epsilon(0.01));
    CHECK(seen.rate == Approx(exact.rate).epsilon(0.05));
}

TEST_CASE("With corrected gradients little of a wave's energy is lost to numbers", "[validation][fluid]") {
    const auto exact = wave::exact(2500), corrected = wave::swing<wave::CorrectedSea>(32, 2500, 6),
               plain = wave::swing<wave::Sea>(32, 2500, 6);
    CAPTURE(corrected.period, plain.period, exact.period, corrected.rate, plain.rate, exact.rate);
    CHECK(corrected.period == Approx(exact.period).epsilon(0.01));
    CHECK(corrected.rate == Approx(exact.rate).epsilon(0.1));
    CHECK(plain.rate > 1.2 * exact.rate);
}
