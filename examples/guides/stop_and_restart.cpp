// Stop and restart: a dam break that is stopped half way by Ctrl-C goes on from its checkpoint, to the same last bit as
// if it had never stopped, with its table and its snapshots.
//
//   build/guide_stop_and_restart
#include <imbibe/imbibe.hpp>

#include <csignal>
#include <cstdio>

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<sph::LinearState, sph::WeaklyCompressible<K>, sph::MonaghanViscosity<K>> {};
struct Tank : sph::Wall<> {};
struct Contact : sph::CouplingOf<Water, Tank> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, Contact>;

/// The scene as it is made, for a run from the start and for one that goes on: materials, settings and phases come from
/// here, all that changes in a run from the checkpoint.
Scene make() {
    const double dx = 0.02;
    Scene scene({.gravity = {0, -9.81}, .support_radius = 2.6 * dx});
    Water water{{.density = 1000, .sound_speed = 28}};
    water.set(sph::MonaghanViscosityParameters{.alpha = 0.02});
    scene.add(water, sph::fill(sph::Box<2>({0, 0}, {0.2, 0.4}), dx), dx);
    scene.add(Tank{{.density = 1000}}, sph::tank(sph::Box<2>({0, 0}, {0.8, 0.6}), dx, 3), dx);
    return scene;
}

/// Runs to 0.35 s, or until somebody asks it to stop: here the program itself, as Ctrl-C would, at `stop`, s.
sph::RunOutcome run(Scene& scene, bool restart, double stop) {
    sph::Run run(scene, {.folder = "out-restart",
                         .end = 0.35,
                         .table_interval = 0.01,
                         .snapshot_interval = 0.05,
                         .restart = restart,
                         .overwrite = !restart,
                         .quiet = true});
    double farthest = 0; // what the program itself counts goes along in the checkpoints
    run.keep("farthest", farthest);
    run.column("front", "m", [&] {
        const double front = scene.get<Water>()[sph::position].col(0).maxCoeff();
        farthest = std::max(farthest, front);
        return front;
    });
    run.column("farthest", "m", [&] { return farthest; });
    run.each([&](Scene& now) {
        if (now.time() > stop)
            std::raise(SIGINT);
    });
    return run.go();
}

/// Where the particles are, in the order in which they were added; a checkpoint sorts them by place.
Eigen::MatrixXd places(const Scene& scene) {
    const auto water = scene.get<Water>();
    Eigen::MatrixXd all(water.size(), 2);
    for (int i = 0; i < water.size(); ++i)
        all.row(water.ids()[static_cast<std::size_t>(i)]) = water[sph::position].row(i);
    return all;
}

int main() {
    Scene first = make(), second = make(), whole = make();
    const auto stopped = run(first, false, 0.2);
    std::printf("stopped at %.4f s: %s\n", stopped.time, stopped.failure.c_str());
    const auto ended = run(second, true, 1); // the program is started again
    whole.run_until(0.35);                   // and one that was not stopped

    const Eigen::MatrixXd found = places(second), expected = places(whole);
    std::ifstream lines("out-restart/run.csv");
    const long long rows = std::count(std::istreambuf_iterator<char>(lines), {}, '\n') - 1;
    std::printf("at %.2f s after %lld steps: off by %g m from the run that was not stopped; %lld rows, %zu snapshots\n",
                ended.time, ended.steps, (found - expected).cwiseAbs().maxCoeff(), rows, ended.snapshots);
    return stopped.stopped && found == expected && ended.steps == whole.steps() && rows == 36 ? 0 : 1;
}
