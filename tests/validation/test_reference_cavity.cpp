// A cavity whose lid moves, as in benchmarks/validation, coarse; docs/validation.md has it finer.
#include <benchmarks/validation/cavity.hpp>
#include <catch_shim.hpp>

namespace cavity = validation::cavity;

// A coarse cavity: off by 6 to 10, 11 to 15 and 12 to 17 %, with the length of the steps, to which this flow of few
// particles answers as to any small change; a quarter of that with twice as many (docs/validation.md). The bounds were
// chosen after those runs.
TEST_CASE("A lid drives the flow in a cavity", "[validation][fluid]") {
    const auto lines = cavity::drive(20, 10);
    CAPTURE(lines.least_u, lines.greatest_v, lines.least_v, lines.lightest, lines.densest);
    CHECK(lines.least_u == Approx(-0.21090).epsilon(0.12));
    CHECK(lines.greatest_v == Approx(0.17527).epsilon(0.14));
    CHECK(lines.least_v == Approx(-0.24533).epsilon(0.18));
    CHECK(lines.lightest > 0.96); // sound at ten times the lid's speed: 1 % in smooth flow, more in the lid's corners
    CHECK(lines.densest < 1.04);
}
