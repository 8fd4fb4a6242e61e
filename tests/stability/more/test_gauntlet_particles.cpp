// Limits that hard starts ask for, too few neighbours, fast particles, and two fluids a thousand times apart in
// density. Rows 11, 12, 18 and 22 of the gauntlet.
#include "margins.hpp"
#include <cases/stability/limits.hpp>
#include <cases/stability/starts.hpp>
#include <cases/stability/two_fluids.hpp>

using namespace gauntlet;

TEST_CASE("Particles that start deep in a hard repulsion get back what it stored", "[stability]") { // row 11
    for (const double near : {0.3, 0.8})
        check_margin([near](const Plan& plan) { return stability::let_go(plan, near, 1e8); });
}

TEST_CASE("A force that states its own limit is stable up to it", "[stability]") {
    CHECK(stability::swing({.cfl = 0.9}).stable);
    CHECK(!stability::swing({.cfl = 1.05}).stable);
}

TEST_CASE("Where a support is warned of, gradients are about half of what they should be", "[stability]") { // row 12
    const auto check = [](auto kernel) {
        using K = decltype(kernel);
        CHECK(stability::gradient_of_x<K, 2>(1.29) < 0.6);
        CHECK(stability::gradient_of_x<K, 3>(1.29) < 0.6);
        CHECK(stability::gradient_of_x<K, 2>(2.6) == Approx(1).margin(0.06));
        CHECK(stability::gradient_of_x<K, 3>(2.6) == Approx(1).margin(0.06));
    };
    check(imbibe::WendlandC2{});
    check(imbibe::CubicSpline{});
    check(imbibe::Spiky{});
}

TEST_CASE("A support with too few neighbours is warned of, with the number", "[stability]") { // row 12
    const auto warnings = [](double support) {
        using stability::dx;
        using Water = stability::WeaklyCompressible::Water;
        imbibe::Solver<2, double, imbibe::SymplecticEuler, Water> scene({.support_radius = support * dx});
        scene.add(stability::water_of<stability::WeaklyCompressible>(30),
                  imbibe::fill(imbibe::Box<2>{{0, 0}, {8 * dx, 8 * dx}}, dx), dx);
        return scene.warnings();
    };
    REQUIRE(warnings(1.29).size() == 1);
    CHECK_THAT(warnings(1.29)[0], imbibe_test::contains("1.29 spacings") && imbibe_test::contains("neighbours"));
    CHECK(warnings(1.31).empty());
}

TEST_CASE("No pair nearer than nine tenths of a support is missed, however fast particles fly", "[stability]") {
    for (const double way : {0.003, 0.04, 0.3, 10.0}) // row 22
        CHECK(stability::fast_swarm<90>({.value = way}).signs[0].worst == 0);
    CHECK(stability::fast_swarm<99>({.value = 0.01}).signs[0].worst > 0); // the lists do serve several steps
}

TEST_CASE("Pressure is continuous to a spacing of water between fluids a thousand times apart",
          "[stability]") { // row 18
    const Outcome light = stability::layers({.cfl = 0.5, .value = 1000});
    INFO(words(light));
    CHECK(light.stable);
}
