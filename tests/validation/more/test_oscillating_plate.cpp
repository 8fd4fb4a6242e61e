// The plate that swings in a rigid root, coarse and for ten periods; tests/validation/long has it finer.
#include <cases/validation/oscillating_plate.hpp>
#include <catch_shim.hpp>

namespace oscillating_plate_test {

namespace plate = validation::oscillating_plate;

TEST_CASE("A plate loses nothing in ten periods", "[validation][solid]") {
    const auto seen =
        plate::swing(plate::rubber<validation::ElasticPlate>(), {.across = 4, .support_ratio = 1.5, .periods = 10});
    REQUIRE(seen.peaks.size() == 10);
    CAPTURE(seen.period(), seen.peaks);
    CHECK(seen.period() == Approx(0.2552).epsilon(0.1)); // four particles: 1/16 of the stiffness is missing, and more
    CHECK(seen.peaks.back() > 0.98 * seen.peaks.front());
    CHECK(seen.peaks.back() < 1.02 * seen.peaks.front());
}

} // namespace oscillating_plate_test
