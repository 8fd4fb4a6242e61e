// Go back: a dam break whose steps are too long is stopped by its guard; it goes back to its last checkpoint and goes
// on with steps half as long, and its table shows nothing of the detour.
//
//   build/guide_go_back
#include <imbibe/imbibe.hpp>

#include <cstdio>

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::DensityDiffusion<K>, sph::DensityFloor,
                          sph::VolumePressure<K>, sph::MonaghanViscosity<K>> {};
struct Tank : sph::Wall<> {};
struct Contact : sph::Coupling<Water, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                               sph::Into<Water, sph::VolumeContinuity<K>>> {};

int main() {
    const std::filesystem::path folder = "out-go-back";
    const double dx = 0.02, end = 0.35;
    std::filesystem::remove_all(folder);
    sph::require_writable(folder);

    // 0.4 of the limits is what a scene takes by itself; 1.6 times them is more than they bear.
    sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, Contact> scene(
        {.gravity = {0, -9.81}, .support_radius = 2.6 * dx, .cfl = 1.6});
    Water water{{.density = 1000, .sound_speed = 28}};
    water.set(sph::MonaghanViscosityParameters{.alpha = 0.02});
    const auto pool = scene.add(water, sph::fill(sph::Box<2>({0, 0}, {0.2, 0.4}), dx), dx);
    scene.add(Tank{{.density = 1000}}, sph::tank(sph::Box<2>({0, 0}, {0.8, 0.6}), dx, 3), dx);

    sph::Table table(folder / "front.csv", {{"time", "s"}, {"front", "m"}});
    const auto row = [&](const auto& now) { table.row({now.time(), now[pool][sph::position].col(0).maxCoeff()}); };
    int returns = 0;
    const auto tell = [&](const sph::Error& error) { // the scene is back at its checkpoint
        ++returns;
        std::printf("%s\nOn from %.4f s with steps %g times as long as they were.\n", error.what(), scene.time(),
                    scene.shortened());
    };
    sph::Guard<2> guard({.interval = 20, .lower = {-dx, -dx}, .upper = {0.8 + dx, 0.6 + dx}});
    sph::run_and_recover(scene, end, guard, folder / "checkpoint", 600, 4, tell, sph::every(0.01, row));

    std::ifstream lines(folder / "front.csv");
    const long long rows = std::count(std::istreambuf_iterator<char>(lines), {}, '\n') - 1;
    std::printf("at %.2f s after %lld steps; it went back %d times; %lld rows\n", scene.time(), scene.steps(), returns,
                rows);
    return returns > 0 && rows == 36 && scene.time() == end ? 0 : 1;
}
