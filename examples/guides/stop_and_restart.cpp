// Stop and restart: a dam break that is stopped half way goes on from its last checkpoint, to the same last bit as if
// it had never stopped, with its table and its snapshots.
//
//   build/guide_stop_and_restart
#include <imbibe/imbibe.hpp>

#include <cstdio>

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::DensityDiffusion<K>, sph::DensityFloor,
                          sph::VolumePressure<K>, sph::MonaghanViscosity<K>> {};
struct Tank : sph::Wall<> {};
struct Contact : sph::Coupling<Water, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                               sph::Into<Water, sph::VolumeContinuity<K>>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, Contact>;

const std::filesystem::path folder = "out-restart", checkpoint = folder / "checkpoint", curve = folder / "front.csv";

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

/// Runs until `end`, s, from the start or, if there is a checkpoint, from there. Table and snapshots need not be told:
/// what the run writes from its first moment on replaces what is there of that time and later.
Scene run(double end) {
    Scene scene = make();
    if (std::filesystem::exists(checkpoint)) {
        sph::read_checkpoint(scene, checkpoint);
        std::printf("goes on from %.4f s\n", scene.time());
    }
    sph::Table table(curve, {{"time", "s"}, {"front", "m"}});
    const auto row = [&](const Scene& now) {
        table.row({now.time(), now.get<Water>()[sph::position].col(0).maxCoeff()});
    };
    scene.run_until(end, sph::every(0.01, row), sph::every(0.05, sph::Snapshots(folder)),
                    sph::Checkpoints(checkpoint, 600, 0.1)); // every ten minutes, and every 0.1 s of simulated time
    return scene;
}

int main() {
    std::filesystem::remove_all(folder); // a checkpoint of an earlier run would be taken up
    sph::require_writable(folder);

    run(0.27);               // stopped at 0.27 s, as by a power cut: what came after the checkpoint at 0.2 s is lost
    Scene later = run(0.35); // the program is started again
    Scene whole = make();    // and one that was not stopped
    whole.run_until(0.35);

    const auto found = later.get<Water>()[sph::position], expected = whole.get<Water>()[sph::position];
    std::ifstream lines(curve);
    const long long rows = std::count(std::istreambuf_iterator<char>(lines), {}, '\n') - 1;
    std::printf("at %.2f s after %lld steps: off by %g m from the run that was not stopped; %lld rows\n", later.time(),
                later.steps(), (found - expected).cwiseAbs().maxCoeff(), rows);
    return found == expected && later.steps() == whole.steps() && rows == 36 ? 0 : 1;
}
