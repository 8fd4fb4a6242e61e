// A run that is stopped goes on as if it had not been, with its table and its snapshots; a folder that holds a run is
// neither overwritten nor gone on with by other physics unless that is said.
#include "folder.hpp"
#include "full_disk.hpp"

#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/output/run.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

#include <catch_shim.hpp>

#include <csignal>
#include <limits>

namespace run_test {

namespace {

namespace sph = imbibe;
using K = sph::WendlandC2;
using imbibe_test::contains;

struct Water
    : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>, sph::MonaghanViscosity<K>> {};
struct Tank : sph::Wall<> {};
struct Sides : sph::Coupling<Water, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                             sph::Into<Water, sph::VolumeContinuity<K>>> {};
using Scene = sph::Solver<2, float, sph::SymplecticEuler, Water, Tank, Sides>;
constexpr sph::PhaseHandle<Water> water;

Scene make(double cfl = 0.4, double time_step = 0) {
    const double dx = 0.05;
    Scene scene({.gravity = {0, -9.81},
                 .support_radius = 2.6 * dx,
                 .cfl = cfl,
                 .time_step = time_step,
                 .search_interval = 5,
                 .search_skin = 0.1,
                 .threads = 1});
    scene.add(Water{{.density = 1000, .sound_speed = 20}}, sph::fill(sph::Box<2>({0, 0}, {0.5, 0.5}), dx), dx);
    scene.add(Tank{{.density = 1000}}, sph::tank(sph::Box<2>({0, 0}, {1, 1}), dx, 3), dx);
    return scene;
}

sph::RunSettings settings(const std::filesystem::path& folder, double end) {
    return {.folder = folder,
            .end = end,
            .table_interval = 1e-3,
            .snapshot_interval = 5e-3,
            .checkpoint_interval = 1e6,
            .quiet = true};
}

struct Done {
    sph::RunOutcome outcome;
    int calls;       // of the observer: kept, so they go on to be counted
    long long front; // the kept number of another type
    Scene scene;
};
Done run(const sph::RunSettings& with, double interrupted_at = 1e9, double stiffness = 1, double cfl = 0.4) {
    Done done{{}, 0, 0, make(cfl)};
    sph::Run run(done.scene, with);
    run.column("front", "m", [&] { return static_cast<double>(done.scene[water][sph::position].col(0).maxCoeff()); });
    run.keep("calls", done.calls).keep("front", done.front);
    run.depends_on({"the stiffness", stiffness, "Pa"}).depends_on({.name = "cfl", .value = cfl, .may_change = true});
    run.each([&](Scene& now) {
        ++done.calls;
        done.front = now.steps();
        if (now.time() > interrupted_at)
            std::raise(SIGINT);
    });
    done.outcome = run.go();
    return done;
}
void check_same(const std::filesystem::path& a, const std::filesystem::path& b, const std::string& name) {
    INFO(name);
    CHECK_FALSE(output_test::content(a / name).empty());
    CHECK((output_test::content(a / name) == output_test::content(b / name)));
}

} // namespace

TEST_CASE("A run that is stopped by Ctrl-C goes on to the same bits, table and snapshots", "[run]") {
    const auto whole = output_test::fresh("run_whole"), parts = output_test::fresh("run_in_parts");
    const Done once = run(settings(whole, 0.03));
    CHECK(once.outcome.failure == "");
    CHECK(once.outcome.time == Approx(0.03));
    CHECK(once.outcome.snapshots == 7);

    auto with = settings(parts, 0.03);
    const Done first = run(with, 0.012);
    CHECK(first.outcome.stopped);
    CHECK(first.outcome.failure == "restart goes on from here");
    CHECK(first.outcome.time > 0.012);
    CHECK(first.outcome.time < 0.02);
    CHECK_THROWS_WITH(run(with), contains("holds a run to 0.01") && contains("that has not reached its end"));

    with.restart = true;
    const Done second = run(with);
    CHECK(second.outcome.failure == "");
    CHECK(second.outcome.steps == once.outcome.steps);
    CHECK(second.front == once.front);
    CHECK(second.calls == once.calls + 1); // it is called before the first step of each part
    for (const std::string name : {"run.csv", "water.pvd", "water_000006.vtp", "finished.txt"})
        check_same(whole, parts, name);
    CHECK((second.scene[water][sph::position].matrix() == once.scene[water][sph::position].matrix()));

    with.end = 0.04; // a finished run goes on to a later end
    CHECK(run(with).outcome.time == Approx(0.04));
    with.end = 0.01;
    CHECK_THROWS_WITH(run(with), contains("after the end time of 0.01 s; give a later end"));
}

TEST_CASE("A run goes on with the physics that it began with", "[run]") {
    const auto folder = output_test::fresh("run_depends");
    auto with = settings(folder, 0.01);
    run(with, 0.002);
    with.restart = true;
    const auto checkpoint = output_test::content(folder / "checkpoint");
    CHECK_THROWS_WITH(run(with, 1e9, 2), contains("has the stiffness: 1 Pa; now it is 2 Pa") &&
                                             contains("give the stiffness as before, or begin anew in another folder"));
    CHECK((output_test::content(folder / "checkpoint") == checkpoint));
    CHECK(run(with, 1e9, 1, 0.3).outcome.failure == ""); // of the scheme
}

TEST_CASE("A run takes away what another has left, if it may", "[run]") {
    const auto folder = output_test::fresh("run_anew");
    auto with = settings(folder, 0.01);
    with.products = {"curve.png"};
    run(with, 0.002); // not finished
    std::ofstream(folder / "curve.png") << "of the first";
    CHECK_THROWS_WITH(run(with), contains(folder.string()) && contains("overwrite begins anew"));
    CHECK(std::filesystem::exists(folder / "curve.png"));
    with.overwrite = true;
    with.snapshot_interval = 0;
    CHECK(run(with).outcome.failure == "");
    for (const char* name : {"curve.png", "water.pvd", "tank.pvd", "checkpoint.previous.previous"})
        CHECK_FALSE(std::filesystem::exists(folder / name));
    with.overwrite = false; // it has reached its end: nothing is lost
    CHECK(run(with).outcome.failure == "");

    with.restart = true; // from the one before the last
    with.end = 0.02;
    CHECK(run(with, 0.015).outcome.stopped);
    with.previous = true;
    CHECK(run(with).outcome.time == Approx(0.02));
}

TEST_CASE("A run that goes wrong says how it is gone on with", "[run]") {
    const auto folder = output_test::fresh("run_wrong");
    auto scene = make(0.4, 0.02);
    sph::Run wrong(scene, settings(folder, 1));
    wrong.guard() = sph::Guard<2>({.interval = 1});
    const auto outcome = wrong.go();
    CHECK_THAT(outcome.failure, contains("times the limit") && contains("The particles as they were: ") &&
                                    contains("restart goes on from the last checkpoint, which was good, for example "
                                             "with time_step 0.01"));
    CHECK_FALSE(outcome.stopped);
    CHECK(std::filesystem::exists(folder / "broken" / "water.pvd"));
    CHECK(std::filesystem::exists(folder / "checkpoint"));
    CHECK_FALSE(std::filesystem::exists(folder / "finished.txt"));

    auto other = make();
    auto with = settings(output_test::fresh("run_program"), 0.01);
    sph::Run of_program(other, with);
    of_program.each([](Scene& now) { sph::require(now.steps() < 5, "the program's own word"); });
    CHECK_THROWS_WITH(of_program.go(), "the program's own word"); // no matter of the run

    auto third = make();
    with = settings(output_test::fresh("run_disk"), 0.01);
    sph::Run on_full_disk(third, with);
    {
        const output_test::FullDisk full(6000);
        const auto refused = on_full_disk.go();
        CHECK_THAT(refused.failure, contains("disk refused"));
        CHECK_THAT(refused.failure, contains("there is no checkpoint yet, so the run is to begin anew"));
    }
}

TEST_CASE("A run refuses what cannot be one before anything is written", "[run]") {
    const auto folder = output_test::fresh("run_refused") / "not_made";
    const double nan = std::numeric_limits<double>::quiet_NaN();
    auto scene = make();
    const auto refused = [&](auto change) {
        auto with = settings(folder, 0.01);
        change(with);
        try {
            sph::Run run(scene, with);
        } catch (const sph::Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(refused([](auto& s) { s.end = 0; }) == "end time = 0 s; it must be above 0 s");
    CHECK_THAT(refused([&](auto& s) { s.end = nan; }), contains("end time = nan s"));
    CHECK_THAT(refused([](auto& s) { s.table_interval = -1; }), contains("table_interval = -1 s; it must be"));
    CHECK_THAT(refused([](auto& s) { s.snapshot_interval = -1; }), contains("snapshot_interval = -1 s"));
    CHECK_THAT(refused([&](auto& s) { s.checkpoint_interval = nan; }), contains("checkpoint_interval = nan s"));
    CHECK_THAT(refused([](auto& s) { s.folder = ""; }), contains("a run needs a folder"));
    CHECK_THAT(refused([](auto& s) { s.restart = true; }),
               contains("there is no checkpoint") && contains("to go on from"));
    CHECK_THAT(refused([](auto& s) { s.previous = true; }), contains("previous without restart"));
    CHECK_THAT(refused([](auto& s) { s.restart = s.overwrite = true; }), contains("either goes on or begins anew"));
    CHECK_FALSE(std::filesystem::exists(folder));
    CHECK(refused([](auto&) {}) == "");
}

TEST_CASE("A run in a few lines", "[run]") {
    const auto folder = output_test::fresh("run_short");
    auto scene = make();
    imbibe::Run run(scene, {.folder = folder, .end = 0.02, .table_interval = 2e-3, .snapshot_interval = 0.01});
    run.column("height", "m", [&] { return scene[water][imbibe::position].col(1).maxCoeff(); });
    const imbibe::RunOutcome outcome = run.go();
    CHECK(outcome.failure == "");
    const std::string table = output_test::content(folder / "run.csv");
    CHECK(table.starts_with("time [s],height [m],time step [s],what limits the time step\n0,0.47"));
    CHECK(std::count(table.begin(), table.end(), '\n') == 12);
}

} // namespace run_test
