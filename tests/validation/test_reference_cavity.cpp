// A cavity whose lid moves, as in benchmarks/validation, coarse; docs/validation.md has it finer.
#include <benchmarks/validation/cavity.hpp>
#include <catch_shim.hpp>

namespace cavity = validation::cavity;

// A coarse cavity: off by 2 to 8, 7 to 11 and 6 to 11 % from eight different starts, and so with the rounding of
// compilers and pack widths, to which this flow of few particles answers as to any small change; by less with twice as
// many (docs/validation.md). The bounds are their mean and three times their scatter.
TEST_CASE("A lid drives the flow in a cavity", "[validation][fluid]") {
    const auto lines = cavity::drive<cavity::Oil>(24, 10);
    CAPTURE(lines.least_u, lines.greatest_v, lines.least_v, lines.lightest, lines.densest);
    CHECK(lines.least_u == Approx(cavity::at_100.least_u).epsilon(0.10));
    CHECK(lines.greatest_v == Approx(cavity::at_100.greatest_v).epsilon(0.145));
    CHECK(lines.least_v == Approx(cavity::at_100.least_v).epsilon(0.14));
    CHECK(lines.lightest > 0.96); // sound at ten times the lid's speed: 1 % in smooth flow, more in the lid's corners
    CHECK(lines.densest < 1.04);
}

// Off by 3.6 to 4.5, 6.8 to 8.0 and 5.7 to 6.7 % from eight different starts; the bounds are as above.
TEST_CASE("With corrected gradients a lid drives the flow as it should with few particles", "[validation][fluid]") {
    const auto lines = cavity::drive<cavity::CorrectedOil>(24, 10);
    CAPTURE(lines.least_u, lines.greatest_v, lines.least_v, lines.lightest, lines.densest);
    CHECK(lines.least_u == Approx(cavity::at_100.least_u).epsilon(0.05));
    CHECK(lines.greatest_v == Approx(cavity::at_100.greatest_v).epsilon(0.09));
    CHECK(lines.least_v == Approx(cavity::at_100.least_v).epsilon(0.072));
    CHECK(lines.lightest > 0.99);
    CHECK(lines.densest < 1.04);
}
