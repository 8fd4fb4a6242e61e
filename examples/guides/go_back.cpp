// Go back: a dam break whose steps are too long is stopped by its guard; it goes back to its last checkpoint and goes
// on with steps half as long, and its table shows nothing of the detour.
//
//   build/guide_go_back
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/monitor/guard.hpp>
#include <imbibe/monitor/progress.hpp>
#include <imbibe/output/recover.hpp>
#include <imbibe/output/table.hpp>
#include <imbibe/presets/sound_water.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace sph = imbibe;
using Preset = sph::presets::SoundWater;

int main() {
    const std::filesystem::path folder = "out-go-back";
    const double dx = 0.02, end = 0.35;
    std::filesystem::remove_all(folder);
    sph::require_writable(folder);

    // A scene takes 0.75 of the limits unless told otherwise; 1.6 times them is more than they bear.
    Preset::Scene<2, double> scene({.gravity = {0, -9.81}, .support_radius = 2.6 * dx, .cfl = 1.6});
    Preset::Water water{{.density = 1000, .sound_speed = 28, .viscosity = 1e-3}};
    Preset::set_coefficients(water);
    const auto pool = scene.add(water, sph::fill(sph::Box<2>({0, 0}, {0.2, 0.4}), dx), dx);
    scene.add(Preset::Vessel{{.density = 1000}}, sph::tank(sph::Box<2>({0, 0}, {0.8, 0.6}), dx, 3), dx);
    Preset::set_coefficients(scene.coupling<Preset::Sides>(), water);

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
