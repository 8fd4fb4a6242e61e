// surface_height: level, sloping and tilted surfaces, at walls, across periodic sides and far from the origin; drops,
// and where there is no fluid.
#include "scenes.hpp"

#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/monitor/surface_height.hpp>

#include <catch_shim.hpp>

#include <cmath>
#include <vector>

namespace surface_height_test {

namespace sph = imbibe;
using monitor_test::Pool, monitor_test::Water;
constexpr double dx = 0.05;

const Water water{{.density = 1000, .sound_speed = 30}};

template <int dim>
sph::Settings<dim> settings_with_gravity(double origin = 0) {
    sph::Settings<dim> settings{.support_radius = 2.6 * dx, .threads = 1};
    settings.gravity[dim - 1] = -9.81;
    settings.origin.fill(origin);
    return settings;
}

/// A block 1 m wide and 0.5 m deep, its lower corner at the scene's origin.
template <int dim, class Real>
void check_level(double origin, double disorder, double tolerance) {
    Pool<dim, Real> scene(settings_with_gravity<dim>(origin));
    const sph::Point<dim> lower = sph::Point<dim>::Constant(origin);
    sph::Point<dim> upper = sph::Point<dim>::Constant(origin + 1);
    upper[dim - 1] = origin + 0.5;
    const auto pool =
        scene.add(water, sph::jitter<dim>(sph::fill(sph::Box<dim>{lower, upper}, dx), disorder * dx, 3), dx);
    for (const double at : {0.5, 0.512, 0.525, 0.0, 1.0}) { // between, on and beside particles; at the walls
        sph::Point<dim> place = sph::Point<dim>::Constant(origin + at);
        const double height = sph::surface_height(scene, pool, place);
        CAPTURE(dim, origin, disorder, at, (height - origin - 0.5) / dx);
        CHECK(std::abs(height - origin - 0.5) < tolerance * dx);
        place[dim - 1] = origin - 7; // of no matter
        CHECK(std::abs(sph::surface_height(scene, pool, place) - height) < 1e-3 * dx);
        CHECK(std::abs(sph::surface_height(scene, pool, place, 4 * dx) - origin - 0.5) < tolerance * dx);
    }
}

TEST_CASE("a level surface, in the middle and at a wall, on a lattice and shaken", "[monitor]") {
    check_level<2, double>(0, 0, 0.02);
    check_level<3, double>(100, 0, 0.02);
    check_level<2, float>(1000, 0, 0.02);
    check_level<2, double>(0, 0.2, 0.15);
    check_level<3, double>(0, 0.2, 0.15);
}

TEST_CASE("a sloping surface, across a periodic side too", "[monitor]") {
    auto settings = settings_with_gravity<2>();
    settings.periodic_length = {1, 0};
    Pool<2> scene(settings);
    const auto surface = [](double x) { return 0.5 + 0.2 * std::abs(x - 0.5); };
    std::vector<sph::Point<2>> points; // as many in each column, so that its surface is where it should be
    for (const auto& p : sph::fill(sph::Box<2>{{0, 0}, {1, 0.5}}, dx))
        points.push_back({p[0], p[1] * surface(p[0]) / 0.5});
    const auto pool = scene.add(water, points, dx);
    auto view = scene[pool];
    for (int i = 0; i < view.size(); ++i)
        view[sph::density](i) = 1000 * 0.5 / surface(view[sph::position](i, 0));
    for (const double x : {0.2, 0.31, 0.8})
        CHECK(std::abs(sph::surface_height(scene, pool, {x, 0}) - surface(x)) < 0.1 * dx);
    CHECK(std::abs(sph::surface_height(scene, pool, {0, 0}) - 0.6) < 0.3 * dx); // a ridge, which is smoothed
    CHECK(sph::surface_height(scene, pool, {0, 0}) == Approx(sph::surface_height(scene, pool, {1, 0})).epsilon(1e-12));
}

TEST_CASE("up is against gravity", "[monitor]") {
    auto settings = settings_with_gravity<2>();
    settings.gravity = {-6, -8}; // up is (0.6, 0.8)
    Pool<2> scene(settings);
    std::vector<sph::Point<2>> points; // a block whose surface is 0.3 m along that from the origin
    for (const auto& p : sph::fill(sph::Box<2>{{-0.5, -0.2}, {0.5, 0.3}}, dx))
        points.push_back({0.8 * p[0] + 0.6 * p[1], -0.6 * p[0] + 0.8 * p[1]});
    const auto pool = scene.add(water, points, dx);
    CHECK(std::abs(sph::surface_height(scene, pool, {0, 0}) - 0.3) < 0.02 * dx);
    CHECK(std::abs(sph::surface_height(scene, pool, {0.8 * 0.1 + 0.6 * 5, -0.6 * 0.1 + 0.8 * 5}) - 0.3) < 0.02 * dx);
}

TEST_CASE("drops over the fluid do not count, a sheet does; and where there is none", "[monitor]") {
    Pool<2> scene(settings_with_gravity<2>());
    auto points = sph::fill(sph::Box<2>{{0, 0}, {1, 0.5}}, dx);
    points.push_back({0.5, 1});
    points.push_back({3, 1});
    for (const auto& p : sph::fill(sph::Box<2>{{0, 1}, {0.4, 1.2}}, dx))
        points.push_back(p);
    const auto pool = scene.add(water, points, dx);
    CHECK(sph::surface_height(scene, pool, {0.7, 0}) == Approx(0.5).margin(0.02 * dx));
    CHECK(sph::surface_height(scene, pool, {0.5, 0}, 4 * dx) == Approx(0.5).margin(0.02 * dx)); // under the drop
    CHECK(sph::surface_height(scene, pool, {0.2, 0}) == Approx(1.2).margin(0.02 * dx));
    CHECK(std::isnan(sph::surface_height(scene, pool, {3.1, 0})));
    CHECK(sph::surface_height(scene, pool, {5, 0}, 0, -1) == -1);
    CHECK(sph::surface_height(scene, pool, {3.1, 0}, 0, -1) == -1);
}

TEST_CASE("what a gauge cannot do it says", "[monitor]") {
    Pool<2> level({.support_radius = 2.6 * dx, .threads = 1});
    const auto pool = level.add(water, sph::fill(sph::Box<2>{{0, 0}, {1, 0.5}}, dx), dx);
    REQUIRE_THROWS_WITH(sph::surface_height(level, pool, {0, 0}), imbibe_test::contains("no gravity"));
    level.set_gravity({0, -1});
    REQUIRE_THROWS_WITH(sph::surface_height(level, pool, {0, 0}, -1), imbibe_test::contains("support of -1 m"));
    auto settings = settings_with_gravity<2>();
    settings.periodic_length = {0, 2};
    Pool<2> falling(settings);
    const auto rain = falling.add(water, sph::fill(sph::Box<2>{{0, 0}, {1, 0.5}}, dx), dx);
    REQUIRE_THROWS_WITH(sph::surface_height(falling, rain, {0, 0}), imbibe_test::contains("periodic along axis 1"));
}

} // namespace surface_height_test
