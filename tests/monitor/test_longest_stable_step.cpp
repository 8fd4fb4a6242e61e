// How long a step a scene bears, asked of the scene itself, against exact limits and against what terms predict.
#include "scenes.hpp"

#include <catch_shim.hpp>

#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/geometry.hpp>
#include <imbibe/monitor/longest_stable_step.hpp>
#include <imbibe/time/leapfrog.hpp>

#include <vector>

namespace longest_stable_step_test {

namespace sph = imbibe;
using imbibe_test::contains;
using K = sph::WendlandC2;

/// dv_a/dt = -k x_a - d v_a, without a limit of its own.
struct DampedSpring : sph::NotStiff {
    static constexpr double k = 1e6, d = 500; // 1/s^2, 1/s
    using reads = sph::Fields<sph::position, sph::velocity>;
    using adds = sph::Fields<sph::acceleration>;
    constexpr auto operator()(const auto& a) const { return -k * a[sph::position] - d * a[sph::velocity]; }
};
struct Swinging : sph::Fluid<DampedSpring> {};
/// Particles that are pushed away from the origin, whatever the step.
struct Repeller : sph::NotStiff {
    using reads = sph::Fields<sph::position>;
    using adds = sph::Fields<sph::acceleration>;
    constexpr auto operator()(const auto& a) const { return 1e24 * a[sph::position]; }
};
struct Leaving : sph::Fluid<Repeller> {};
struct Water : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>> {};
struct Syrup : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>, sph::MorrisViscosity<K>> {
};
struct Brine : sph::Fluid<sph::LinearState, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Gas : sph::Fluid<sph::LinearState, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Interface : sph::Coupling<Brine, Gas, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
using Body = monitor_test::Block<sph::StVenantKirchhoff>;

template <class Phase, class Integrator = sph::SymplecticEuler, class Real = double>
double of_one_particle() {
    sph::Solver<2, Real, Integrator, Phase> scene({.support_radius = 0.01, .threads = 1});
    scene.add(Phase{{.density = 1000, .sound_speed = 1}}, {{0.01, 0}}, 0.01);
    return sph::longest_stable_step(scene);
}

constexpr double dx = 0.01;

/// What a periodic square of a fluid bears, over its shortest limit.
template <class Phase>
double of_a_square(const Phase& material) {
    constexpr double length = 12 * dx;
    sph::Solver<2, double, sph::SymplecticEuler, Phase> scene(
        {.support_radius = 2.6 * dx, .periodic_length = {length, length}, .threads = 1});
    scene.add(material, sph::fill(sph::Box<2>{{0, 0}, {length, length}}, dx), dx);
    scene.prepare();
    return sph::longest_stable_step(scene) / scene.time_step_limits().front().seconds;
}

TEST_CASE(
    "longest_stable_step of a spring is 2 over its frequency, damped by what the integrator makes of the damping") {
    const auto exact = [](double k, double d) { return (std::sqrt(d * d + 4 * k) - d) / k; }; // k dt^2 + 2 d dt = 4
    const double damped = exact(DampedSpring::k, DampedSpring::d);
    CHECK(of_one_particle<Swinging>() == Approx(damped).epsilon(0.05));
    CHECK(of_one_particle<Swinging, sph::SymplecticEuler, float>() == Approx(damped).epsilon(0.05));
}

TEST_CASE("longest_stable_step of water and of syrup lies where terms and linear theory have it") {
    // 0.9 H/c for the fastest wave on a lattice (state/wave_speed.hpp), of which `sound` takes 0.6
    CHECK(of_a_square(Water{{.density = 1000, .sound_speed = 30}}) == Approx(1.5).epsilon(0.05));
    const double syrup = of_a_square(Syrup{{.density = 1000, .sound_speed = 30, .viscosity = 200}});
    CHECK(syrup > 1.2);
    CHECK(syrup < 1.6);
}

TEST_CASE("longest_stable_step of a cube of two by two by two particles is that of its stiffest corner") {
    monitor_test::BlockScene<3, sph::StVenantKirchhoff> scene({.support_radius = 2.6 * dx, .threads = 1});
    Body body{{.density = 1000, .sound_speed = 10, .shear_modulus = 4e4}};
    scene.add(body, sph::fill(sph::Box<3>{{0, 0, 0}, {2 * dx, 2 * dx, 2 * dx}}, dx), dx);
    // with Poisson's ratio 0.3187: 2 over the frequency is between 0.734 and 0.70 spacings per longitudinal wave
    const double asked = sph::longest_stable_step(scene) * body.longitudinal_wave_speed() / dx;
    CHECK(asked < 0.75);
    CHECK(asked > 0.69);
}

TEST_CASE("longest_stable_step leaves the scene as it is") {
    sph::Solver<2, double, sph::SymplecticEuler, Water> scene({.gravity = {0, -10}, .support_radius = 2.6 * dx});
    const auto water =
        scene.add(Water{{.density = 1000, .sound_speed = 30}}, sph::fill(sph::Box<2>{{0, 0}, {0.1, 0.1}}, dx), dx);
    for (int k = 0; k < 5; ++k)
        scene.step();
    const Eigen::MatrixXd places = scene[water][sph::position], densities = scene[water][sph::density];
    const auto ids = scene[water].ids();
    const double time = scene.time(), step = scene.next_step().seconds;
    CHECK(sph::longest_stable_step(scene) > step);
    CHECK((scene[water][sph::position] - places).norm() == 0);
    CHECK((scene[water][sph::density] - densities).norm() == 0);
    CHECK(scene[water].ids() == ids);
    CHECK(scene.time() == time);
    CHECK(scene.next_step().seconds == step);
}

TEST_CASE("longest_stable_step says so where no step is short enough, and checks its settings") {
    CHECK_THROWS_WITH(of_one_particle<Leaving>(), contains("not by the length of the steps"));
    sph::Solver<2, double, sph::SymplecticEuler, Swinging> scene({.support_radius = dx});
    scene.add(Swinging{{.density = 1000, .sound_speed = 1}}, {{dx, 0}}, dx);
    CHECK_THROWS_WITH(sph::longest_stable_step(scene, {.tolerance = 0}), contains("tolerance = 0"));
    CHECK_THROWS_WITH(sph::longest_stable_step(scene, {.steps = 5}), contains("steps = 5"));
    CHECK_THROWS_WITH(sph::longest_stable_step(scene, {.growth = 1}), contains("growth = 1"));
    CHECK_THROWS_WITH(sph::longest_stable_step(scene, {.size = 1}), contains("size = 1 spacings"));
}

TEST_CASE("Phases that weigh each other's masses are as stiff as the ratio of their densities", "[longest]") {
    constexpr double length = 12 * dx;
    for (const double density : {500.0, 100.0, 10.0})
        for (const double support : {2.0, 3.0}) {
            sph::Solver<2, double, sph::SymplecticEuler, Brine, Gas, Interface> scene(
                {.support_radius = support * dx, .periodic_length = {length, 0}, .threads = 1});
            scene.add(Brine{{.density = 1000, .sound_speed = 10}}, sph::fill(sph::Box<2>{{0, 0}, {length, 4 * dx}}, dx),
                      dx);
            scene.add(Gas{{.density = density, .sound_speed = 10}},
                      sph::fill(sph::Box<2>{{0, -4 * dx}, {length, 0}}, dx), dx);
            scene.prepare();
            const auto limit = scene.time_step_limits().front();
            CAPTURE(density, support, limit.reason);
            const double share = sph::longest_stable_step(scene) / limit.seconds;
            CHECK(share > 1);
            CHECK(share < 1.7);
            CHECK((limit.reason == "pressure between phases") == (density < 400));
        }
}

} // namespace longest_stable_step_test
