// Water without gravity and walls, as in cases/validation, coarse; docs/validation.md has it finer.
#include <cases/validation/elliptic_drop.hpp>
#include <cases/validation/square_patch.hpp>
#include <catch_shim.hpp>

TEST_CASE("A drop is drawn out into the ellipse it should become", "[validation][fluid]") {
    const auto shapes = validation::elliptic_drop::stretch(20, {0.0038, 0.0076});
    CAPTURE(shapes[0].long_axis, shapes[0].short_axis, shapes[1].long_axis, shapes[1].short_axis, shapes[1].reach,
            shapes[1].energy);
    CHECK(shapes[0].long_axis == Approx(1.43922).epsilon(0.01));
    CHECK(shapes[0].short_axis == Approx(0.69482).epsilon(0.01));
    CHECK(shapes[1].long_axis == Approx(1.94452).epsilon(0.01));
    CHECK(shapes[1].short_axis == Approx(0.51427).epsilon(0.01));
    CHECK(shapes[1].energy > 0.98); // chosen after a run: 0.999 with 25 particles over the radius
    CHECK(shapes[1].energy < 1);
}

TEST_CASE("A square patch turns without tearing", "[validation][fluid]") {
    const auto seen = validation::square_patch::turn(40);
    CAPTURE(seen.pressure[0], seen.pressure[1], seen.angular_momentum, seen.energy, seen.lightest, seen.densest);
    CHECK(seen.angular_momentum == Approx(1).epsilon(1e-3));
    CHECK(seen.energy < 1);
    CHECK(seen.lightest > 0.9); // no void, no clump
    CHECK(seen.densest < 1.1);
    CHECK(seen.pressure[0] == Approx(-0.147343).epsilon(0.06));
    CHECK(seen.pressure[1] == Approx(-0.114670).epsilon(0.06));
}
