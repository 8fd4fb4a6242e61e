// Drops, of a liquid in another one and of one liquid with nothing around it: left alone for very many steps, and
// thrown on a soft plate.
#include <cases/validation/free_drop.hpp>
#include <cases/validation/sessile_drop.hpp>

#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/monitor/guard.hpp>
#include <imbibe/presets/sponge_in_two_liquids.hpp>
#include <imbibe/presets/wetting_liquid.hpp>

#include <catch_shim.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace drops_test {

namespace sph = imbibe;
using Preset = sph::presets::SpongeInTwoLiquids;
using Point = Eigen::Vector2d;

/// The least distance of two particles of a view, whose particles are few.
double nearest(const auto& view) {
    double least = 1e9;
    const auto x = view[sph::position];
    for (int i = 0; i < view.size(); ++i)
        for (int j = 0; j < i; ++j)
            least = std::min(least, static_cast<double>((x.row(i) - x.row(j)).norm()));
    return least;
}

TEST_CASE("A drop keeps its particles apart for 100,000 steps", "[stability]") {
    const double spacing = 1.0 / 6;
    auto scene = validation::sessile_drop::drop({4, 4}, spacing, {.viscosity = 0.03, .cfl = 0.75},
                                                [](const Point& x) { return std::hypot(x[0] - 2, x[1] - 2) < 1; });
    for (int i = 0; i < 100000; ++i)
        scene.step();
    const auto drop = scene.get<Preset::Water>();
    const double apart = nearest(drop) / spacing, speed = drop[sph::velocity].rowwise().norm().maxCoeff();
    CAPTURE(scene.time(), apart, speed);
    CHECK(apart > 0.7);
    CHECK(speed < 0.05); // sqrt(sigma/(rho R))
}

TEST_CASE("A drop that hits a soft plate bends it, and neither enters it", "[stability]") {
    const double spacing = 1.0 / 16, low = 13 * spacing, thick = 8 * spacing, R = 0.5;
    Preset::Scene<2, double> scene({.gravity = {0, 0}, .support_radius = 3 * spacing, .threads = 1});
    const Preset::Interface interface { .surface_tension = 1, .contact_angle = std::numbers::pi / 2 };
    Preset::Water water{{.density = 1, .sound_speed = 20, .viscosity = 0.03}};
    Preset::Oil oil{{.density = 0.1, .sound_speed = 60, .viscosity = 0.01}};
    Preset::set_coefficients(water, interface, spacing);
    Preset::set_coefficients(oil, interface, spacing);
    const sph::Box<2> box({0, 0}, {4, 3}), plate({0, low}, {4, low + thick});
    const Point centre(2, low + thick + R + 2 * spacing);
    std::vector<Point> drop, around;
    for (const auto& x : sph::fill(box, spacing))
        if ((x - centre).norm() < R)
            drop.push_back(x);
        else if (!plate.contains(x))
            around.push_back(x);
    scene.add(water, drop, spacing);
    scene.add(oil, around, spacing);
    scene.add(Preset::Vessel{{.density = 1, .viscosity = 0.03}}, sph::tank(box, spacing, 4), spacing);
    const auto body = scene.add(Preset::elastic(2000, 0.3, 1, spacing), sph::fill(plate, spacing), spacing);
    Preset::set_coefficients(scene, interface);
    scene.hold(body, [](const Point& x) { return x[0] < 0.3 || x[0] > 3.7; });
    scene.get<Preset::Water>()[sph::velocity].col(1).setConstant(-3); // a Weber number of 4.5 with R
    const auto sag = [&] {
        const auto x = scene.get<Preset::Sponge>()[sph::position];
        return low + 0.5 * spacing - x.col(1).minCoeff();
    };
    sph::Guard<2> guard({.lower = {0, 0}, .upper = {4, 3}});
    double deepest = 0;
    scene.run_until(1.5, [&](const auto& s) {
        guard(s);
        deepest = std::max(deepest, sag());
    });
    const auto wet = scene.get<Preset::Water>();
    const auto solid = scene.get<Preset::Sponge>();
    double between = 1e9;
    for (int i = 0; i < wet.size(); ++i)
        for (int j = 0; j < solid.size(); ++j)
            between = std::min(between,
                               static_cast<double>((wet[sph::position].row(i) - solid[sph::position].row(j)).norm()));
    CAPTURE(deepest / spacing, between / spacing, nearest(wet) / spacing, wet[sph::position].col(1).minCoeff());
    CHECK(deepest > 0.05 * spacing);
    CHECK(deepest < 4 * spacing);
    CHECK(between > 0.5 * spacing);
    CHECK(nearest(wet) > 0.4 * spacing);
    CHECK(wet[sph::position].col(1).minCoeff() > low + thick - deepest - spacing);
}

TEST_CASE("A free drop keeps its particles apart and its shape for 100,000 steps", "[stability]") {
    namespace drops = validation::free_drop;
    auto scene = drops::drop<2>(6, 0.03, [](const auto& x) { return x.norm() < 1; });
    for (int i = 0; i < 100000; ++i)
        scene.step();
    const auto drop = scene.get<drops::Water>();
    const double apart = 6 * nearest(drop), speed = drop[sph::velocity].rowwise().norm().maxCoeff();
    const double farthest =
        (drop[sph::position].rowwise() - drop[sph::position].colwise().mean()).rowwise().norm().maxCoeff();
    CAPTURE(scene.time(), apart, speed, farthest);
    CHECK(apart > 0.45);  // along the surface they lie about so close
    CHECK(speed < 0.001); // sqrt(sigma/(rho R))
    CHECK(farthest < 1.05);
}

TEST_CASE("A free drop that hits a soft plate bends it, and neither enters it", "[stability]") {
    using Free = sph::presets::WettingLiquid;
    const double spacing = 1.0 / 16, thick = 8 * spacing, R = 0.5;
    Free::ElasticScene<2, double> scene({.support_radius = 5 * spacing, .threads = 1});
    std::vector<Point> drop;
    const Point centre(0, thick + R + 7 * spacing);
    for (const auto& x : sph::fill(sph::Box<2>({-1, 0}, {1, 3}), spacing))
        if ((x - centre).norm() < R)
            drop.push_back(x);
    scene.add(Free::Water{{.density = 1, .sound_speed = 60, .viscosity = 0.03}}, drop, spacing);
    const sph::Box<2> plate({-2, 0}, {2, thick});
    const auto body = scene.add(Free::elastic(2000, 0.3, 1, spacing), sph::fill(plate, spacing), spacing);
    scene.add(Free::Vessel{{.density = 1}}, sph::fill(sph::Box<2>({-2, -3}, {2, -2}), spacing), spacing); // far below
    Free::set_coefficients(scene, {.surface_tension = 1, .contact_angle = std::numbers::pi / 2});
    scene.hold(body, [](const Point& x) { return std::abs(x[0]) > 1.7; });
    sph::settle_surface<Free::Water>(scene);
    scene.get<Free::Water>()[sph::velocity].col(1).setConstant(-6); // a Weber number of 18 with R
    double deepest = 0;
    scene.run_until(scene.time() + 1.5, [&](const auto& s) {
        deepest = std::max(deepest, 0.5 * spacing - s.template get<Free::Sponge>()[sph::position].col(1).minCoeff());
    });
    const auto wet = scene.get<Free::Water>();
    const auto solid = scene.get<Free::Sponge>();
    double between = 1e9;
    for (int i = 0; i < wet.size(); ++i)
        between = std::min(
            between, (solid[sph::position].rowwise() - wet[sph::position].row(i).eval()).rowwise().norm().minCoeff());
    const double lowest = wet[sph::position].col(1).minCoeff();
    const double densest = wet[sph::density].maxCoeff();
    CAPTURE(deepest / spacing, between / spacing, nearest(wet) / spacing, densest, lowest);
    CHECK(deepest > 0.05 * spacing);
    CHECK(deepest < 8 * spacing);
    CHECK(between > 0.4 * spacing);
    CHECK(nearest(wet) > 0.3 * spacing); // the repulsion from half a spacing on is soft
    CHECK(densest < 1.1);
    CHECK(lowest > thick - deepest - spacing);
}

} // namespace drops_test
