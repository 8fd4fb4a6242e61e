// A motion that all particles share limits no step: limits and steps are those of the same scene at rest.
#include <imbibe/coupling/modified_repulsion.hpp>
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/riemann.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/monitor/guard.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

#include <catch_shim.hpp>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace common_motion_test {

namespace {

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>, sph::MonaghanViscosity<K>,
                          sph::ModifiedRepulsion> {};
struct Oil : sph::Fluid<sph::LinearState, sph::RiemannContinuity<K>, sph::RiemannPressure<K>> {};
struct Moving : sph::Wall<> {};
struct Beside : sph::Coupling<Water, Oil, sph::VolumeContinuity<K>, sph::VolumePressure<K>> {};
struct InTank : sph::Coupling<Water, Moving, sph::Into<Moving, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                              sph::Into<Water, sph::VolumeContinuity<K>>> {};

constexpr double dx = 0.05, c = 20;
const sph::Point<2> fast = sph::Point<2>(0.6, 0.8) * 100 * c;

template <class View>
void stir(const View& phase, const sph::Point<2>& common, double speed) {
    std::mt19937 random(1);
    auto v = phase[sph::velocity];
    for (int i = 0; i < phase.size(); ++i)
        for (int d = 0; d < 2; ++d)
            v(i, d) = common[d] + speed * (2 * std::ldexp(static_cast<double>(random()), -32) - 1);
}

/// Water, oil beside it, both in motion.
auto two_blocks(const sph::Point<2>& common, double time_step = 0) {
    sph::Solver<2, double, sph::SymplecticEuler, Water, Oil, Beside> scene(
        {.gravity = {0, -9.81}, .support_radius = 3 * dx, .time_step = time_step, .threads = 2});
    Water water{{.density = 1000, .sound_speed = c}};
    water.set(sph::MonaghanViscosityParameters{.alpha = 0.02, .beta = 2});
    water.set(sph::ModifiedRepulsionParameters{.speed = 1, .range = 0.5});
    const auto stirred = [&](auto phase, double speed) { stir(scene[phase], common, speed); };
    stirred(scene.add(water, sph::jitter(sph::fill(sph::Box<2>{{0, 0}, {0.5, 0.5}}, dx), 0.1 * dx, 1), dx), 1);
    stirred(scene.add(Oil{{.density = 800, .sound_speed = c}},
                      sph::jitter(sph::fill(sph::Box<2>{{0.5, 0}, {1, 0.5}}, dx), 0.1 * dx, 2), dx),
            2);
    return scene;
}

/// Water in a tank.
auto in_tank(const sph::Point<2>& common) {
    sph::Solver<2, double, sph::SymplecticEuler, Water, Moving, InTank> scene({.support_radius = 3 * dx, .threads = 1});
    Water water{{.density = 1000, .sound_speed = c}};
    water.set(sph::ModifiedRepulsionParameters{.speed = 1, .range = 0.5});
    const sph::Box<2> inside{{0, 0}, {0.5, 0.5}};
    const auto liquid = scene.add(water, sph::fill(inside, dx), dx);
    const auto tank = scene.add(Moving{{.density = 1000}}, sph::tank(inside, dx, 3), dx);
    stir(scene[liquid], common, 1);
    stir(scene[tank], common, 0);
    return scene;
}

template <class Scene>
void check_same_limits(const Scene& at_rest, const Scene& moving) {
    const auto expected = at_rest.time_step_limits(), found = moving.time_step_limits();
    REQUIRE(found.size() == expected.size());
    REQUIRE(found.size() > 2);
    for (std::size_t k = 0; k < found.size(); ++k) {
        CHECK(found[k].reason == expected[k].reason);
        CHECK(found[k].where == expected[k].where);
        CHECK(std::abs(found[k].seconds / expected[k].seconds - 1) < 1e-9);
    }
}

} // namespace

TEST_CASE("A motion that all particles share changes no limit and no step") {
    auto at_rest = two_blocks({0, 0}), moving = two_blocks(fast);
    at_rest.prepare();
    moving.prepare();
    check_same_limits(at_rest, moving);
    double worst = 0;
    for (int k = 0; k < 200; ++k) {
        const double expected = at_rest.step();
        worst = std::max(worst, std::abs(moving.step() / expected - 1));
    }
    CHECK(worst < 1e-6);
    CHECK_NOTHROW(sph::Guard<2>{}.look(moving));
    CHECK_NOTHROW(sph::Guard<2>{}(moving));
}

TEST_CASE("A fixed step is as long for a scene in motion as for one at rest") {
    const double step = 0.35 * two_blocks({0, 0}).next_step().seconds / 0.4;
    auto moving = two_blocks(fast, step);
    moving.prepare();
    CHECK(moving.warnings().empty());
    auto too_long = two_blocks(fast, 20 * step);
    too_long.prepare();
    CHECK(too_long.warnings().size() == 1);
}

TEST_CASE("Water moves against its walls, which may move with it") {
    auto at_rest = in_tank({0, 0}), moving = in_tank(fast);
    at_rest.prepare();
    moving.prepare();
    check_same_limits(at_rest, moving);
    // against walls at rest it does not
    auto against = in_tank(fast);
    against.get<Moving>()[sph::velocity].setZero();
    against.prepare();
    CHECK(against.time_step_limits().front().seconds < at_rest.time_step_limits().front().seconds / 20);
    // walls at rest: speeds are as they are
    const auto v = at_rest.get<Water>()[sph::velocity];
    CHECK(at_rest.engine().motion<Water>().speed == std::sqrt(v.rowwise().squaredNorm().maxCoeff()));
}

TEST_CASE("A host that makes one particle fast is noticed before the next step, in a scene in motion too") {
    auto moving = two_blocks(fast);
    moving.step();
    const double before = moving.next_step().seconds;
    moving.get<Water>()[sph::velocity](3, 0) += 3 * c;
    moving.prepare();
    CHECK(moving.next_step().seconds < before / 2);
}

} // namespace common_motion_test
