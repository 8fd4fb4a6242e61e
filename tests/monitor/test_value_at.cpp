// value_at: exact for linear fields, on one side, across periodic sides and far from the origin; what it is where there
// is nothing.
#include "scenes.hpp"

#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/monitor/value_at.hpp>

#include <catch_shim.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace value_at_test {

namespace sph = imbibe;
using monitor_test::Pool, monitor_test::Water;
constexpr double dx = 0.05;

const Water water{{.density = 1000, .sound_speed = 10}};

/// A cloud that fills a unit square (cube) whose lower corner is the origin of the scene, with a linear density and
/// velocity.
template <int dim>
double density_at(const sph::Point<dim>& x) {
    return 1000 + 3 * x[0] - 5 * x[dim - 1];
}
template <int dim>
void check_linear_fields(double origin) {
    sph::Settings<dim> settings{.support_radius = 2.6 * dx, .threads = 1};
    settings.origin.fill(origin);
    Pool<dim> scene(settings);
    const sph::Point<dim> lower = sph::Point<dim>::Constant(origin), upper = sph::Point<dim>::Constant(origin + 1);
    const auto points = sph::jitter<dim>(sph::fill(sph::Box<dim>{lower, upper}, dx), 0.2 * dx, 3);
    const auto pool = scene.add(water, points, dx);
    auto view = scene[pool];
    for (int i = 0; i < view.size(); ++i) {
        const sph::Point<dim> x = view[sph::position].row(i).transpose().array() + origin;
        view[sph::density](i) = density_at<dim>(x);
        view[sph::velocity].row(i) = 2 * x.transpose();
    }
    for (const double at : {0.5, 0.013, 0.0, -0.01, 1.01}) { // inside, at faces, edges and corners, and beyond them
        const sph::Point<dim> place = sph::Point<dim>::Constant(origin + at);
        CAPTURE(dim, origin, at);
        CHECK(sph::value_at(scene, pool, sph::density, place) == Approx(density_at<dim>(place)).epsilon(1e-11));
        const auto v = sph::value_at(scene, pool, sph::velocity, place);
        CHECK((v - 2 * place).norm() < 1e-9 * (1 + place.norm()));
    }
}

TEST_CASE("a linear field is exact everywhere, also on one side of the particles", "[monitor]") {
    for (const double origin : {0.0, 100.0}) {
        check_linear_fields<2>(origin);
        check_linear_fields<3>(origin);
    }
}

TEST_CASE("a value across a periodic side", "[monitor]") {
    Pool<2> scene({.support_radius = 2.6 * dx, .periodic_length = {1, 0}, .threads = 1});
    const auto pool = scene.add(water, sph::fill(sph::Box<2>{{0, 0}, {1, 1}}, dx), dx);
    auto view = scene[pool];
    for (int i = 0; i < view.size(); ++i) // even about both sides, so that its slope there is zero
        view[sph::density](i) = 1000 + std::abs(view[sph::position](i, 0) - 0.5);
    const double right = sph::value_at(scene, pool, sph::density, {1, 0.5}),
                 left = sph::value_at(scene, pool, sph::density, {0, 0.5});
    CHECK(right == Approx(left).epsilon(1e-12));
    CHECK(right < 1000.49); // from one side alone, 1000.5
    CHECK(right > 1000.45);
}

TEST_CASE("a value is not drawn out of noise far beyond what is around it", "[monitor]") {
    Pool<2> scene({.support_radius = 2.6 * dx, .threads = 1});
    const auto pool = scene.add(water, sph::fill(sph::Box<2>{{0, 0}, {1, 2 * dx}}, dx), dx); // two rows
    auto view = scene[pool];
    for (int i = 0; i < view.size(); ++i)
        view[sph::density](i) = view[sph::position](i, 1) > dx ? 1000 : 1100;
    CHECK(sph::value_at(scene, pool, sph::density, {0.5, 0}, 4 * dx) == Approx(1150));   // half a row down
    CHECK(sph::value_at(scene, pool, sph::density, {0.5, -dx}, 4 * dx) == Approx(1200)); // one and a half: not 1250
}

TEST_CASE("what a value is from few particles, and from none", "[monitor]") {
    Pool<2> scene({.support_radius = 0.2, .threads = 1});
    const auto pool = scene.add(water, {{0, 0}, {0.1, 0}, {2, 0}}, dx);
    auto view = scene[pool];
    for (int i = 0; i < view.size(); ++i)
        view[sph::density](i) = 1000 + view[sph::position](i, 0);
    CHECK(sph::value_at(scene, pool, sph::density, {2.1, 0}) == Approx(1002));                  // one: its value
    CHECK(sph::value_at(scene, pool, sph::density, {0.05, 0}) == Approx(1000.05));              // two: their mean
    CHECK(sph::value_at(scene, pool, sph::density, {0.01, 0.02}) < 1000.05);                    // nearer to the first
    CHECK(std::isnan(sph::value_at(scene, pool, sph::density, {1, 0})));                        // none
    CHECK(sph::value_at(scene, pool, sph::density, {1, 0}, 0, 0) == 0);                         // none, as told
    CHECK(sph::value_at(scene, pool, sph::density, {1, 0}, 1.5) == Approx(1000.7).margin(0.5)); // some, further away
    REQUIRE_THROWS_WITH(sph::value_at(scene, pool, sph::density, {0, 0}, -1), imbibe_test::contains("support of -1 m"));
}

} // namespace value_at_test
