// Water that falls freely, before it touches anything: it has no pressure, and falls as fast as a stone. And water that
// stands bears its weight, by what knows of the fall (SupportedShare).
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/riemann.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/leapfrog.hpp>
#include <imbibe/time/midpoint_runge_kutta.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <catch_shim.hpp>

#include <array>
#include <cmath>

namespace free_fall_test {

namespace {

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Diffusive : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::DensityDiffusion<K>,
                              sph::VolumePressure<K>, sph::MonaghanViscosity<K>> {};
struct Riemann : sph::Fluid<sph::LinearState, sph::RiemannContinuity<K>, sph::RiemannPressure<K>> {};

template <int dim>
sph::Box<dim> box(double side) {
    Eigen::Matrix<double, dim, 1> upper = Eigen::Matrix<double, dim, 1>::Constant(side);
    return {Eigen::Matrix<double, dim, 1>::Zero(), upper};
}

// A block of water whose particles lie in disorder is let go.
template <class Water, int dim, class Real, class Integrator = sph::SymplecticEuler>
void check_fall(double pressure_bound, double speed_bound) {
    constexpr double dx = 0.05, c = 44, seconds = 0.1;
    std::array<double, dim> g{1.5};
    g[dim - 1] = -9.81;
    sph::Solver<dim, Real, Integrator, Water> scene({.gravity = g, .support_radius = 3 * dx, .threads = 2});
    const auto points = sph::jitter(sph::fill(box<dim>(0.35), dx), 0.2 * dx, 1);
    const auto water = scene.add(Water{{.density = 1000, .sound_speed = c}}, points, dx);
    scene.run_until(seconds);
    REQUIRE(scene.steps() > 50);
    const auto view = scene[water];
    CHECK(view[sph::pressure].cwiseAbs().maxCoeff() <= pressure_bound * 1000 * 9.81 * 0.35);
    for (int d = 0; d < dim; ++d)
        CHECK((view[sph::velocity].col(d).array() - static_cast<Real>(g[static_cast<std::size_t>(d)] * seconds))
                  .abs()
                  .maxCoeff() < speed_bound * 9.81 * seconds);
    CHECK(view[sph::supported_share].cwiseAbs().maxCoeff() == 0);
}

} // namespace

TEST_CASE("In free fall water has no pressure, and falls by g t") {
    check_fall<Diffusive, 2, double>(1e-12, 1e-12);
    check_fall<Diffusive, 3, double>(1e-12, 1e-12);
    check_fall<Riemann, 2, double>(1e-12, 1e-12);
    check_fall<Riemann, 3, double>(1e-12, 1e-12);
    check_fall<Diffusive, 2, double, sph::Leapfrog>(1e-12, 1e-12);
    check_fall<Riemann, 2, double, sph::MidpointRungeKutta>(1e-12, 1e-12);
    check_fall<Diffusive, 2, float>(1e-5, 1e-5); // rounding
    check_fall<Riemann, 3, float>(1e-5, 1e-5);
}

} // namespace free_fall_test
