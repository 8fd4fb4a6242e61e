// A run that is continued from a checkpoint goes on to the same last bit, with every integrator and with lists of
// neighbours that serve several steps.
#include "scene_bits.hpp"

#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/output/checkpoint.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/leapfrog.hpp>
#include <imbibe/time/midpoint_runge_kutta.hpp>
#include <imbibe/time/position_verlet.hpp>
#include <imbibe/time/predictor_corrector.hpp>
#include <imbibe/time/staggered_leapfrog.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <catch_shim.hpp>

#include <filesystem>
#include <random>

namespace restart_bits_test {

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Gas : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>, sph::MonaghanViscosity<K>> {
};

/// A hot gas, whose particles change their cells all the time.
template <class Integrator>
auto hot_gas(bool periodic, int interval) {
    constexpr double dx = 0.04;
    const double length = periodic ? 1 : 0;
    sph::Solver<2, double, Integrator, Gas> scene({.support_radius = 2.6 * dx,
                                                   .cfl = 0.2,
                                                   .periodic_length = {length, length},
                                                   .search_interval = interval,
                                                   .search_skin = interval > 1 ? 0.1 : 0,
                                                   .threads = 1});
    const auto gas =
        scene.add(Gas{{.density = 1000, .sound_speed = 10}}, sph::fill(sph::Box<2>({0, 0}, {1, 1}), dx), dx);
    std::mt19937 generator(1);
    std::normal_distribution<double> speed(0, 2);
    for (int i = 0; i < scene[gas].size(); ++i)
        for (int d = 0; d < 2; ++d)
            scene[gas][sph::velocity](i, d) = speed(generator);
    return scene;
}

template <class Integrator>
void check_restarts(int interval) {
    const auto file = std::filesystem::temp_directory_path() / "imbibe_test_restart_bits.checkpoint";
    for (const bool periodic : {false, true}) {
        auto run = hot_gas<Integrator>(periodic, interval);
        for (int k = 0; k < 12; ++k) {
            for (int n = 0; n < 4; ++n)
                run.step();
            sph::write_checkpoint(run, file);
            auto continued = hot_gas<Integrator>(periodic, interval);
            sph::read_checkpoint(continued, file);
            auto further = run;
            for (int n = 0; n < 3; ++n) {
                further.step();
                continued.step();
            }
            CAPTURE(periodic, k);
            REQUIRE(imbibe_test::bits_of(further) == imbibe_test::bits_of(continued));
        }
    }
    std::filesystem::remove(file);
    std::filesystem::remove(file.string() + ".previous");
}

TEST_CASE("A continued run has the bits of the run, whatever moves first", "[checkpoint]") {
    check_restarts<sph::SymplecticEuler>(1);
    check_restarts<sph::Leapfrog>(1);
    check_restarts<sph::Leapfrog>(7);
    check_restarts<sph::PositionVerlet>(1);
    check_restarts<sph::PositionVerlet>(7);
    check_restarts<sph::StaggeredLeapfrog>(7);
    check_restarts<sph::MidpointRungeKutta>(7);
    check_restarts<sph::PredictorCorrector>(7);
}

} // namespace restart_bits_test
