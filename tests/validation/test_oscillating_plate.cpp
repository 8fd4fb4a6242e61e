// The plate that swings in a rigid root, coarse and for ten periods; tests/validation/long has it finer.
#include <benchmarks/validation/oscillating_plate.hpp>
#include <catch_shim.hpp>

TEST_CASE("A plate loses nothing in ten periods", "[validation][solid]") {
    const int periods = 10;
    const auto seen = validation::oscillating_plate::swing(4, 1.5, 0.01, periods);
    REQUIRE(static_cast<int>(seen.peaks.size()) == periods);
    CAPTURE(seen.upward.back() / periods, seen.peaks);
    CHECK(seen.peaks.back() > 0.98 * seen.peaks.front());
    CHECK(seen.peaks.back() < 1.02 * seen.peaks.front());
}
