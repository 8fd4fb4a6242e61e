// A run that is continued from a checkpoint goes on to the same last bit, with every integrator and with lists of
// neighbours that serve several steps.
#include "scene_bits.hpp"

#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/output/checkpoint.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/dual_stepping.hpp>
#include <imbibe/time/leapfrog.hpp>
#include <imbibe/time/midpoint_runge_kutta.hpp>
#include <imbibe/time/position_verlet.hpp>
#include <imbibe/time/predictor_corrector.hpp>
#include <imbibe/time/staggered_leapfrog.hpp>
#include <imbibe/time/subcycled.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

#include <catch_shim.hpp>

#include <filesystem>
#include <fstream>
#include <random>
#include <string>

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

struct Rubber : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::CompressibleNeoHookean,
                           sph::TotalLagrangianForce<K>, sph::TimeAveragedMotion> {};
struct Push : sph::Coupling<Gas, Rubber, sph::Into<Rubber, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                            sph::Into<Gas, sph::VolumeContinuity<K>>> {};

/// Gas that blows on rubber, which takes ten steps and more for one of the gas.
auto blown_rubber(int interval) {
    constexpr double dx = 0.05;
    sph::Solver<2, double, sph::Subcycled<Rubber>, Gas, Rubber, Push> scene(
        {.support_radius = 2.6 * dx, .search_interval = interval, .threads = 1});
    const auto gas =
        scene.add(Gas{{.density = 1000, .sound_speed = 10}}, sph::fill(sph::Box<2>({0, 0}, {0.5, 1}), dx), dx);
    scene.add(Rubber{{.density = 1100, .sound_speed = 100, .shear_modulus = 4e6}},
              sph::fill(sph::Box<2>({0.5, 0.25}, {0.75, 0.75}), dx), dx);
    scene[gas][sph::velocity].col(0).setConstant(1);
    return scene;
}

inline std::string file_bytes(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// @param make makes the scene as it begins
template <class Make>
void check_restarts_of(const Make& make) {
    const auto file = std::filesystem::temp_directory_path() / "imbibe_test_restart_bits.checkpoint";
    auto run = make();
    for (int k = 0; k < 12; ++k) {
        for (int n = 0; n < 4; ++n)
            run.step();
        sph::write_checkpoint(run, file);
        const std::string written = file_bytes(file);
        sph::write_checkpoint(run, file); // when the one before was written makes no difference to the bytes of a file
        REQUIRE(file_bytes(file) == written);
        auto continued = make();
        sph::read_checkpoint(continued, file);
        auto further = run;
        for (int n = 0; n < 3; ++n) {
            further.step();
            continued.step();
        }
        CAPTURE(k);
        REQUIRE(imbibe_test::bits_of(further) == imbibe_test::bits_of(continued));
    }
    std::filesystem::remove(file);
    std::filesystem::remove(file.string() + ".previous");
}
template <class Integrator>
void check_restarts(int interval) {
    for (const bool periodic : {false, true}) {
        CAPTURE(periodic);
        check_restarts_of([&] { return hot_gas<Integrator>(periodic, interval); });
    }
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

TEST_CASE("So has one whose steps are made of shorter ones", "[checkpoint]") {
    using Dual = sph::DualStepping<sph::MonaghanViscosity<K>>;
    check_restarts<Dual>(1);
    check_restarts<Dual>(7);
    CHECK([] {
        auto scene = hot_gas<Dual>(false, 1);
        scene.step();
        return scene.substeps();
    }() > 1);
    check_restarts_of([] { return blown_rubber(1); });
    check_restarts_of([] { return blown_rubber(7); });
    auto scene = blown_rubber(1);
    scene.step();
    CHECK(scene.substeps() > 5);
}

} // namespace restart_bits_test
