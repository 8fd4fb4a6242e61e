// A fluid that fills a box which is periodic on all sides, in the flow of Taylor and Green (1937): its volume stays
// what it is, whatever becomes of the order of its particles, and a scene whose particles nothing keeps in order is
// told so.
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/fluid/particle_shifting.hpp>
#include <imbibe/fluid/riemann.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/methods/corrected_gradients.hpp>
#include <imbibe/monitor/energy.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/midpoint_runge_kutta.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <catch_shim.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace closed_box_test {

namespace {

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Riemann
    : sph::Fluid<sph::LinearState, sph::RiemannContinuity<K>, sph::RiemannPressure<K>, sph::MorrisViscosity<K>> {};
struct Shifted : sph::Fluid<sph::LinearState, sph::RiemannContinuity<K>, sph::RiemannPressure<K>,
                            sph::MorrisViscosity<K>, sph::ParticleShifting<K>> {};
struct Plain : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>, sph::MorrisViscosity<K>> {
};
/// Its continuity equation has a function of one particle.
struct Corrected : sph::Fluid<sph::LinearState, sph::CorrectedGradients<K>, sph::MorrisViscosity<K>> {};

constexpr double c = 10, nu = 1.0 / 50, k = 2 * std::numbers::pi;

/// A unit box, `filled` of it to its height, with vortices of the speed U.
template <class Water, int dim, class Real, class Integrator = sph::SymplecticEuler>
auto vortices(int across, double jitter, double U = 1, double filled = 1, Water water = {}) {
    const double dx = 1.0 / across;
    std::array<double, dim> sides;
    sides.fill(1);
    sph::Solver<dim, Real, Integrator, Water> scene({.support_radius = 3 * dx, .periodic_length = sides, .threads = 2});
    water.density = 1;
    water.sound_speed = c;
    water.viscosity = nu;
    using Point = Eigen::Matrix<double, dim, 1>;
    Point upper = Point::Constant(1);
    upper[1] = filled;
    const auto points = sph::jitter<dim>(sph::fill(sph::Box<dim>{Point::Zero(), upper}, dx), jitter * dx, 1);
    auto view = scene[scene.add(water, points, dx)];
    for (int i = 0; i < view.size(); ++i) {
        const double x = static_cast<double>(view[sph::position](i, 0)),
                     y = static_cast<double>(view[sph::position](i, 1));
        view[sph::velocity](i, 0) = static_cast<Real>(-U * std::cos(k * x) * std::sin(k * y));
        view[sph::velocity](i, 1) = static_cast<Real>(U * std::sin(k * x) * std::cos(k * y));
    }
    return scene;
}
template <class View>
double volume_of(const View& water) {
    return (water[sph::mass].template cast<double>().array() / water[sph::density].template cast<double>().array())
        .sum();
}
template <class View>
double mean_density(const View& water) {
    return water[sph::density].template cast<double>().mean();
}
/// Of the kinetic energy that the exact flow has at this time; the sum over space is 1/4.
template <class Scene, class View>
double share_of_energy(const Scene& scene, const View& water) {
    return sph::kinetic_energy(water) / (0.25 * std::exp(-4 * nu * k * k * scene.time()));
}

} // namespace

TEST_CASE("A fluid that fills a periodic box keeps its volume, and its mean density") {
    for (const double jitter : {0.0, 0.1}) {
        auto scene = vortices<Riemann, 3, float>(12, jitter);
        scene.run_until(0.25);
        const auto water = scene.get<Riemann>();
        CHECK(std::abs(volume_of(water) - 1) < 1e-5);
        CHECK(std::abs(mean_density(water) - 1) < 1e-3);
    }
    auto corrected = vortices<Corrected, 2, double>(16, 0.1);
    corrected.run_until(0.1);
    CHECK(std::abs(volume_of(corrected.get<Corrected>()) - 1) < 1e-12);
    auto two_stages = vortices<Plain, 2, double, sph::MidpointRungeKutta>(16, 0.1);
    two_stages.run_until(0.1);
    CHECK(std::abs(volume_of(two_stages.get<Plain>()) - 1) < 1e-12);
}

TEST_CASE("With shifting and without Riemann dissipation a vortex in a periodic box decays as fast as it should") {
    Shifted water;
    water.set(sph::ParticleShiftingParameters{.strength = 4, .least_speed = 1});
    water.set(sph::RiemannPressureParameters{.eta = 0});
    for (const double jitter : {0.0, 0.1}) {
        auto scene = vortices<Shifted, 3, float>(16, jitter, 1, 1, water);
        scene.run_until(0.25);
        CHECK(std::abs(mean_density(scene.get<Shifted>()) - 1) < 1e-3);
        CHECK(std::abs(share_of_energy(scene, scene.get<Shifted>()) - 1) < 0.03);
        // what the default takes, as the term says
        water.set(sph::RiemannPressureParameters{});
        auto usual = vortices<Shifted, 3, float>(16, jitter, 1, 1, water);
        water.set(sph::RiemannPressureParameters{.eta = 0});
        usual.run_until(0.25);
        CHECK(share_of_energy(usual, usual.get<Shifted>()) == Approx(0.85).margin(0.03));
    }
}

TEST_CASE("What is compressed at the start stays so, and what has a surface keeps no volume") {
    auto compressed = vortices<Plain, 2, double>(16, 0.1);
    compressed.get<Plain>()[sph::density] *= 1.005;
    compressed.run_until(0.1);
    CHECK(std::abs(volume_of(compressed.get<Plain>()) - 1 / 1.005) < 1e-12);
    auto sheet = vortices<Plain, 2, double>(16, 0.1, 1, 0.75);
    const double before = volume_of(sheet.get<Plain>());
    sheet.run_until(0.1);
    CHECK(std::abs(volume_of(sheet.get<Plain>()) - before) > 1e-5);
}

TEST_CASE("A scene is told that nothing keeps the particles of a fluid without a surface in order") {
    const auto warnings = [](auto scene) {
        scene.prepare();
        return scene.warnings();
    };
    const auto told = warnings(vortices<Riemann, 2, double>(16, 0.1));
    REQUIRE(told.size() == 1);
    CHECK_THAT(told[0], imbibe_test::contains("Riemann flows in a box that is periodic on all sides") &&
                            imbibe_test::contains("List ParticleShifting"));
    CHECK(warnings(vortices<Shifted, 2, double>(16, 0.1)).empty());
    CHECK(warnings(vortices<Riemann, 2, double>(16, 0.1, 0.1)).empty());     // sound
    CHECK(warnings(vortices<Riemann, 2, double>(16, 0.1, 1, 0.75)).empty()); // with a surface
}

} // namespace closed_box_test
