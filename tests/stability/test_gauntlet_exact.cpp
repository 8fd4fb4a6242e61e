// Two rows of the gauntlet with other compositions than the rest: pairing, and a free fall that is exact.
#include "margins.hpp"
#include "stability/coupled.hpp"
#include "stability/crowd.hpp"

using namespace gauntlet;

TEST_CASE("Fifty neighbours pair up with a cubic spline, and not with a Wendland kernel", "[stability]") { // row 2
    check_margin(stability::crowded<imbibe::WendlandC2>);
    const Outcome spline = stability::crowded<imbibe::CubicSpline>(Plan{.cfl = 0.4});
    INFO(words(spline));
    CHECK(!spline.stable);
}

TEST_CASE("In free fall nothing moves against anything else", "[stability]") { // row 21
    const Outcome paper = stability::free_fall<stability::PaperCoupling>({.cfl = 0.4});
    INFO(words(paper));
    CHECK(paper.stable);
    CHECK(paper.signs[0].worst < 1e-12);
    CHECK(paper.signs[1].worst < 1e-12);
}
