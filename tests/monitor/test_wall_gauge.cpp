// patch_pressure and WallGauge: forces that are known, on every side and at corners; water at rest; the force on the
// whole wall as the sum of its patches; the mean over a window; what is no patch.
#include "scenes.hpp"

#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/monitor/wall_gauge.hpp>
#include <imbibe/state/hydrostatic.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

#include <catch_shim.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace wall_gauge_test {

namespace sph = imbibe;
using monitor_test::K;
using sph::Sides;

struct Water : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::DensityDiffusion<K>, sph::VolumePressure<K>,
                          sph::MonaghanViscosity<K>> {};
struct Tank : sph::Wall<> {};
struct Block : sph::Wall<> {};
template <class Solid>
struct Contact : sph::Coupling<Water, Solid, sph::Into<Solid, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                               sph::Into<Water, sph::VolumeContinuity<K>>,
                               sph::Into<Solid, sph::ReactionForce<sph::VolumePressure<K>>>> {};
template <int dim>
using Scene = sph::Solver<dim, double, sph::SymplecticEuler, Water, Tank, Block, Contact<Tank>, Contact<Block>>;

constexpr double g = 9.81;
Water water() {
    Water material{{.density = 1000, .sound_speed = 40}};
    material.set(sph::MonaghanViscosityParameters{.alpha = 0.1});
    return material;
}
const Tank wall{{.density = 1000}};

template <int dim>
Scene<dim> scene_of(double dx, double support = 3) {
    sph::Settings<dim> settings{.support_radius = support * dx, .cfl = 0.4, .threads = 1};
    settings.gravity[dim - 1] = -g;
    if (dim == 3)
        settings.periodic_length[1] = 8 * dx;
    return Scene<dim>(settings);
}
/// A tank 1 m long and deep; in space 8 spacings wide, and periodic along that.
template <int dim>
sph::Box<dim> room(double dx, double height = 1) {
    sph::Point<dim> upper = sph::Point<dim>::Constant(height);
    upper[0] = 1;
    if (dim == 3)
        upper[1] = 8 * dx;
    return {sph::Point<dim>::Zero(), upper};
}
template <int dim>
std::vector<sph::Point<dim>> tank(double dx) {
    return sph::tank(room<dim>(dx, 1.2), dx, 3, dim == 2 ? Sides::y_high : Sides::z_high | Sides::y);
}
/// From one height to another on the wall at x = 1 m, or at x = 0.
template <int dim>
sph::WallPatch<dim> upright(double dx, double from, double to, Sides side = Sides::x_high) {
    sph::WallPatch<dim> patch{room<dim>(dx).lower(), room<dim>(dx).upper(), side};
    patch.lower[0] = patch.upper[0] = side == Sides::x_high ? 1 : 0;
    patch.lower[dim - 1] = from;
    patch.upper[dim - 1] = to;
    return patch;
}

template <int dim>
void check_at_rest(double tolerance) {
    const double dx = 0.05;
    auto scene = scene_of<dim>(dx);
    const auto pool = scene.add(water(), sph::fill(room<dim>(dx), dx), dx);
    const auto sides = scene.add(wall, tank<dim>(dx), dx);
    sph::start_hydrostatic(scene, pool, 1);
    scene.run_until(0.02);
    for (const double from : {0.0, 0.1, 0.23, 0.5, 0.75}) {
        const double middle = from + 0.05, pressure = 1000 * g * (1 - middle);
        CAPTURE(dim, from, pressure);
        for (const Sides side : {Sides::x_high, Sides::x_low})
            CHECK(sph::patch_pressure(scene, upright<dim>(dx, from, from + 0.1, side), sides) ==
                  Approx(pressure).epsilon(tolerance));
    }
    sph::WallPatch<dim> floor{room<dim>(dx).lower(), room<dim>(dx).upper(), dim == 2 ? Sides::y_low : Sides::z_low};
    floor.upper[dim - 1] = 0;
    CHECK(sph::patch_pressure(scene, floor, sides) == Approx(1000 * g).epsilon(tolerance)); // to both of its corners
    floor.lower[0] = 0.9;
    CHECK(sph::patch_pressure(scene, floor, sides) == Approx(1000 * g).epsilon(tolerance));
    // Above the water there is none, and the whole wall bears half of rho g depth^2.
    CHECK(std::abs(sph::patch_pressure(scene, upright<dim>(dx, 1.15, 1.2), sides)) < 1e-9);
    const auto whole = upright<dim>(dx, 0, 1.2);
    CHECK(1.2 * sph::patch_pressure(scene, whole, sides) == Approx(500 * g).epsilon(tolerance));
}
TEST_CASE("water at rest presses with rho g depth, at the foot of the wall too", "[monitor]") {
    check_at_rest<2>(0.01);
    check_at_rest<3>(0.02);
}

TEST_CASE("the force on a wall is the sum of those on its patches, wherever they end", "[monitor]") {
    const double dx = 0.05;
    auto scene = scene_of<2>(dx);
    scene.add(water(), sph::jitter(sph::fill(room<2>(dx), dx), 0.2 * dx, 5), dx);
    const auto sides = scene.add(wall, tank<2>(dx), dx);
    scene.run_until(0.05);
    const auto view = scene[sides];
    double force = 0;
    for (int i = 0; i < view.size(); ++i)
        if (view[sph::position](i, 0) > 1)
            force += view[sph::reaction_force](i, 0);
    REQUIRE(force > 100);
    double sum = 0, from = 0;
    for (const double to : {0.013, 0.2, 0.431, 0.9, 1.2}) {
        sum += (to - from) * sph::patch_pressure(scene, upright<2>(dx, from, to), sides);
        from = to;
    }
    CHECK(sum == Approx(force).epsilon(1e-12));
    CHECK(1.2 * sph::patch_pressure(scene, upright<2>(dx, 0, 1.2), sides) == Approx(force).epsilon(1e-12));
}

/// Forces that the test gives to the particles of a wall, and what the gauge makes of them.
TEST_CASE("a force that is known, particle by particle", "[monitor]") {
    const double dx = 0.1;
    auto scene = scene_of<2>(dx);
    const auto sides = scene.add(wall, tank<2>(dx), dx);
    auto view = scene[sides];
    const auto push = [&](double x, double y, double force) { // on the particle nearest to a place, along x
        int nearest = 0;
        for (int i = 1; i < view.size(); ++i)
            if ((view[sph::position].row(i) - Eigen::RowVector2d(x, y)).norm() <
                (view[sph::position].row(nearest) - Eigen::RowVector2d(x, y)).norm())
                nearest = i;
        view[sph::reaction_force](nearest, 0) = force;
    };
    const auto pressure = [&](double from, double to, Sides side = Sides::x_high) {
        return sph::patch_pressure(scene, upright<2>(dx, from, to, side), sides);
    };
    CHECK(pressure(0.1, 0.5) == 0); // before the first step
    push(1.05, 0.35, 8);            // of the layer at the surface, and of the one behind it
    push(1.15, 0.35, 4);
    CHECK(pressure(0.3, 0.4) == Approx(12 / 0.1));
    CHECK(pressure(0.1, 0.5) == Approx(12 / 0.4));
    CHECK(pressure(0.35, 0.36) == Approx(12 / 0.1)); // as for all patches that the particle's square covers
    CHECK(pressure(0.375, 0.5) == Approx(12 * 0.25 / 0.125));
    CHECK(pressure(0.4, 0.6) == Approx(0).margin(1e-9));
    push(-0.05, 0.35, -6); // on the other side the water presses towards -x
    CHECK(pressure(0.3, 0.4, Sides::x_low) == Approx(6 / 0.1));
    push(1.05, -0.15, 5); // behind the corner: mirrored to a height of 0.15
    CHECK(pressure(0.1, 0.2) == Approx(5 / 0.1));
    CHECK(pressure(0, 0.1) == Approx(0).margin(1e-9));
    push(1.05, -0.25, 7); // to one of 0.25, also into a patch that does not reach down to the floor
    CHECK(pressure(0.2, 0.3) == Approx(7 / 0.1));
    push(0.85, -0.05, 100); // the floor before the wall: not the wall's
    CHECK(pressure(0, 1.2) == Approx(24 / 1.2));

    // A block on the floor is another phase than the floor: both, or what lies under the block is missing.
    const auto block = scene.add(Block{{.density = 1000}}, sph::fill(sph::Box<2>{{0.4, 0}, {0.7, 0.3}}, dx), dx);
    scene[block][sph::reaction_force].col(0).setConstant(1);
    auto floor = scene[sides]; // what was added may have moved it
    for (int i = 0; i < floor.size(); ++i) {
        const auto x = floor[sph::position].row(i);
        floor[sph::reaction_force](i, 0) = x[1] < 0 && x[0] > 0.4 && x[0] < 0.7 ? 10 : 0;
    }
    const sph::WallPatch<2> front{{0.4, 0}, {0.4, 0.3}, Sides::x_high};
    CHECK(sph::patch_pressure(scene, front, block, sides) == Approx((9 + 90) / 0.3));
    CHECK(sph::patch_pressure(scene, front, block) == Approx(9 / 0.3));
}

TEST_CASE("a patch across a periodic side", "[monitor]") {
    const double dx = 0.1;
    sph::Settings<2> settings{.support_radius = 3 * dx, .threads = 1};
    settings.periodic_length = {1, 0};
    settings.origin = {50, 0};
    Scene<2> scene(settings);
    const auto floor = scene.add(wall, sph::tank(sph::Box<2>{{50, 0}, {51, 1}}, dx, 3, Sides::x | Sides::y_high), dx);
    scene[floor][sph::reaction_force].col(1).setConstant(-2);
    for (const double from : {50.0, 50.8, 49.8})
        CHECK(sph::patch_pressure(scene, {{from, 0}, {from + 0.4, 0}, Sides::y_low}, floor) ==
              Approx(3 * 2 / dx)); // three layers of them, but only those nearer than a support
}

TEST_CASE("a gauge shows the mean over its window, and keeps impulses", "[monitor]") {
    const double dx = 0.05, window = 7e-3;
    auto scene = scene_of<2>(dx); // water that is let go without pressure: it rings
    scene.add(water(), sph::fill(room<2>(dx), dx), dx);
    const auto sides = scene.add(wall, tank<2>(dx), dx);
    const auto patch = upright<2>(dx, 0, 0.3);
    sph::WallGauge<2> sudden(patch), slow(patch, window), slower(patch, 1);
    struct Step {
        double begin, end, pressure;
    };
    std::vector<Step> steps;
    double before = 0;
    scene.run_until(0.06, [&](const Scene<2>& now) {
        const double pressure = sph::patch_pressure(now, patch, sides);
        if (now.time() > 0)
            steps.push_back({before, now.time(), pressure});
        before = now.time();
        CHECK(sudden(now, sides) == pressure);
        const auto mean = [&](double long_) {
            const double begin = std::max(now.time() - long_, 0.0);
            double impulse = 0;
            for (const Step& step : steps)
                impulse += step.pressure * std::max(step.end - std::max(step.begin, begin), 0.0);
            return now.time() > 0 ? impulse / (now.time() - begin) : pressure;
        };
        const double shown = slow(now, sides), shown_by_the_slower = slower(now, sides);
        CHECK(shown == Approx(mean(window)).margin(1e-6));
        CHECK(shown_by_the_slower == Approx(mean(1)).margin(1e-6));
        CHECK(slow.pressure() == shown);
    });
    REQUIRE(steps.size() > 40);
    CHECK(sudden.pressure() != Approx(slow.pressure()).epsilon(0.01));
}

TEST_CASE("what is no patch of a wall", "[monitor]") {
    const double dx = 0.1;
    auto scene = scene_of<2>(dx);
    const auto sides = scene.add(wall, tank<2>(dx), dx);
    const auto throws = [&](const sph::WallPatch<2>& patch, const char* words) {
        CAPTURE(words);
        REQUIRE_THROWS_WITH(sph::patch_pressure(scene, patch, sides), imbibe_test::contains(words));
    };
    // In the air: its bounds, the wall's nearest particle, and what to do.
    const sph::WallPatch<2> in_the_air{{0.5, 0.4}, {0.5, 0.6}, Sides::x_high};
    throws(in_the_air, "covers 0 % of the patch from (0.5, 0.4) m to (0.5, 0.6) m");
    throws(in_the_air, "the nearest particle of the wall is at (");
    throws(in_the_air, "put the patch on the wall's surface");
    throws({{1, 0.4}, {1, 0.6}, Sides::x_low}, "name the side on which the wall is"); // seen from behind
    throws({{1, 1.1}, {1, 1.6}, Sides::x_high}, "covers 20 %");
    throws({{1, 0.4}, {1.1, 0.6}, Sides::x_high}, "both corners have the same x");
    throws({{1, 0.6}, {1, 0.4}, Sides::x_high}, "the second corner has a greater y");
    throws({{1, 0.4}, {1, 0.6}, Sides::x}, "lies on one side");
    throws({{1, 0.4}, {1, 0.6}, Sides::z_low}, "lies on one side");
    throws({{1, 0.4}, {1, NAN}, Sides::x_high}, "must be finite");
    const sph::WallPatch<2> good{{1, 0.4}, {1, 0.6}, Sides::x_high};
    REQUIRE_THROWS_WITH(sph::WallGauge<2>(good, -1), imbibe_test::contains("window of -1 s"));
    REQUIRE_THROWS_WITH(sph::WallGauge<2>(in_the_air)(scene, sides), imbibe_test::contains("covers 0 %"));
    CHECK(good.area() == Approx(0.2));
    CHECK(sph::WallPatch<3>{{0, 0, 2}, {3, 4, 2}, Sides::z_high}.area() == Approx(12));
}

} // namespace wall_gauge_test
