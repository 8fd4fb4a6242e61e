// Walls that move with the velocity they have.
#include <imbibe/geometry/geometry.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/methods/weakly_compressible.hpp>
#include <imbibe/output/checkpoint.hpp>
#include <imbibe/solver/describe.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/leapfrog.hpp>
#include <imbibe/time/midpoint_runge_kutta.hpp>
#include <imbibe/time/position_verlet.hpp>
#include <imbibe/time/predictor_corrector.hpp>
#include <imbibe/time/staggered_leapfrog.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <catch_shim.hpp>

#include <filesystem>

namespace prescribed_test {

namespace sph = imbibe;
using K = sph::WendlandC2;

struct PistonParameters {
    double acceleration = 0.2; // m/s^2
};
/// v = acceleration t along x, in the middle of the step.
struct Piston {
    using Parameters = PistonParameters;
    using sets = sph::Fields<sph::velocity>;
    Parameters parameters{};
    constexpr auto operator()(const auto& a) const {
        using A = std::remove_cvref_t<decltype(a)>;
        auto v = sph::Vector<typename A::Scalar, A::dimension>::zero();
        v[0] = parameters.acceleration * (a.time + 0.5 * a.time_step);
        return v;
    }
};
struct Water : sph::Fluid<sph::LinearState, sph::WeaklyCompressible<K>> {};
struct Paddle : sph::Wall<Piston> {
    using motion = sph::Prescribed;
};
struct Plate : sph::Wall<> { // a program gives it its velocity
    using motion = sph::Prescribed;
};
struct Floor : sph::Wall<> {};
struct Push : sph::CouplingOf<Water, Paddle> {};
struct Rest : sph::CouplingOf<Water, Floor> {};
static_assert(!Floor::moves && !Paddle::moves && Water::moves);
static_assert(!sph::detail::drifts<Floor> && sph::detail::drifts<Paddle> && sph::detail::drifts<Water>);

/// A pool on a floor of five layers between two paddles that move to the right.
template <class Integrator>
struct Pool {
    using Scene = sph::Solver<2, double, Integrator, Water, Paddle, Plate, Floor, Push, Rest>;
    static constexpr double dx = 0.05, length = 1;
    Scene scene;
    explicit Pool(double step = 5e-4, int interval = 1)
        : scene({.gravity = {0, -1},
                 .support_radius = 2.6 * dx,
                 .time_step = step,
                 .search_interval = interval,
                 .threads = 1}) {
        const auto add = [&](const auto& phase, double x0, double y0, double x1, double y1) {
            scene.add(phase, sph::fill(sph::Box<2>({x0, y0}, {x1, y1}), dx), dx);
        };
        add(Water{{.density = 1000, .sound_speed = 20}}, 0, 0, length, 0.5);
        add(Paddle{{.density = 1000}}, -3 * dx, 0, 0, 1);
        add(Paddle{{.density = 1000}}, length, 0, length + 3 * dx, 1);
        add(Floor{{.density = 1000}}, -1, -3 * dx, length + 1, 0);
        add(Plate{{.density = 1000}}, 5, 0, 5.5, 0.5);
    }
    double paddle() const { return scene.template get<Paddle>()[sph::position].col(0).minCoeff() + 3 * dx - dx / 2; }
};

template <class Integrator>
void follows(double tolerance) {
    Pool<Integrator> pool;
    pool.scene.run_until(0.25);
    const double way = 0.5 * 0.2 * 0.25 * 0.25; // m
    CHECK(pool.paddle() == Approx(way).epsilon(tolerance));
    CHECK(pool.scene.template get<Paddle>()[sph::position].col(1).minCoeff() == Approx(0.025));
    CHECK(pool.scene.template get<Floor>()[sph::position].col(0).minCoeff() == Approx(-1 + 0.025).epsilon(1e-12));
    // The water went along, and did not pass through.
    const auto x = pool.scene.template get<Water>()[sph::position].col(0);
    CHECK(x.minCoeff() > way);
    CHECK(x.maxCoeff() < 1 + way);
    CHECK(x.mean() > 0.5 + 0.3 * way);
}

TEST_CASE("A wall moves with the velocity that a term sets, whatever the integrator", "[motion]") {
    follows<sph::SymplecticEuler>(1e-9);
    follows<sph::StaggeredLeapfrog>(2e-2);
    follows<sph::Leapfrog>(2e-2);
    follows<sph::PositionVerlet>(2e-2);
    follows<sph::MidpointRungeKutta>(2e-2);
    follows<sph::PredictorCorrector>(2e-2);
}

TEST_CASE("A wall moves with the velocity that a program writes, a wall of another kind does not", "[motion]") {
    Pool<sph::SymplecticEuler> pool;
    auto& scene = pool.scene;
    static_assert(sph::detail::contains<sph::Velocity,
                                        std::remove_reference_t<decltype(scene)>::FieldsOf<Plate>>); // read by none
    scene.get<Plate>()[sph::velocity].col(1).setConstant(3);
    const auto before = scene.get<Plate>()[sph::position].col(1).mean();
    const double t = scene.time();
    scene.run_until(0.02);
    CHECK(scene.get<Plate>()[sph::position].col(1).mean() == Approx(before + 3 * (scene.time() - t)).epsilon(1e-12));
    CHECK(scene.get<Plate>()[sph::position].col(0).minCoeff() == Approx(5.025));
}

TEST_CASE("Lists that serve many steps see a wall that moves as prescribed", "[motion]") {
    Pool<sph::SymplecticEuler> every(5e-4, 1), seldom(5e-4, 10);
    every.scene.run_until(0.3);
    seldom.scene.run_until(0.3);
    const auto centre = [](const auto& pool) { return pool.scene.template get<Water>()[sph::position].col(0).mean(); };
    CHECK(centre(seldom) == Approx(centre(every)).epsilon(1e-5));
    CHECK(seldom.paddle() == Approx(every.paddle()).epsilon(1e-12));
}

TEST_CASE("A run with a wall that moves as prescribed goes on from a checkpoint with the same bits", "[motion]") {
    Pool<sph::MidpointRungeKutta> one, two;
    const auto path = std::filesystem::temp_directory_path() / "imbibe_prescribed.checkpoint";
    one.scene.run_until(0.05);
    sph::write_checkpoint(one.scene, path);
    sph::read_checkpoint(two.scene, path);
    std::filesystem::remove(path);
    one.scene.run_until(0.06);
    two.scene.run_until(0.06);
    CHECK(one.scene.get<Paddle>()[sph::position] == two.scene.get<Paddle>()[sph::position]);
    CHECK(one.scene.get<Water>()[sph::position] == two.scene.get<Water>()[sph::position]);
    CHECK(one.paddle() > 1e-4);
}

} // namespace prescribed_test
