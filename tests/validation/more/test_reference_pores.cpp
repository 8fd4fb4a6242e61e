// Pores too small to resolve: a wet layer is pressed and drains, a dry column draws water in; docs/validation.md has them
// finer.
#include <cases/validation/biot.hpp>
#include <cases/validation/imbibition.hpp>

#include <catch_shim.hpp>

TEST_CASE("A layer of wet soil that is pressed drains as Terzaghi says", "[validation][mixture]") {
    for (const auto& found : validation::biot::measure_layer(20)) {
        CAPTURE(found.what, found.computed, found.reference);
        CHECK(std::abs(found.error()) < 0.08); // 2 % is asked of 40
    }
}

TEST_CASE("Suction draws a front into a dry column as Green and Ampt say", "[validation][mixture]") {
    for (const auto& found : validation::imbibition::measure(40)) {
        CAPTURE(found.what, found.computed, found.reference);
        CHECK(std::abs(found.error()) < 0.02);
    }
}
