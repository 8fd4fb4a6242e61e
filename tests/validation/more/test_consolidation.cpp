// A solid of a program's own, whose pores are not resolved, drains as Terzaghi says; docs/validation.md has it finer.
#include <cases/validation/consolidation.hpp>
#include <catch_shim.hpp>

TEST_CASE("A loaded layer of wet soil consolidates as Terzaghi says", "[validation][solid]") {
    for (const auto& degree : validation::consolidation::measure(20)) {
        CAPTURE(degree.what, degree.computed, degree.reference);
        CHECK(std::abs(degree.error()) < 0.03); // nobody asked for a number: 2.6 % at first, 0.5 % later
    }
}
