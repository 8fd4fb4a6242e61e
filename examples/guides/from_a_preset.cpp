// A dam break from a preset: nothing is composed, and linked with imbibe::presets the scene is not compiled either.
//
//   build/guide_from_a_preset           then open out-from-a-preset/water.pvd in ParaView
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/monitor/guard.hpp>
#include <imbibe/monitor/progress.hpp>
#include <imbibe/output/snapshots.hpp>
#include <imbibe/presets/sound_water.hpp>
#include <imbibe/solver/describe.hpp>

#include <cmath>
#include <cstdio>

namespace sph = imbibe;
using Preset = sph::presets::SoundWater;

int main() {
    const double dx = 0.01, width = 0.5, height = 0.5, length = 1.6, g = 9.81, end = 0.3;
    const double fastest = 2 * std::sqrt(g * height); // what a front comes to on a dry bed (Ritter 1892), m/s
    Preset::Scene<2, double> scene({.gravity = {0, -g}, .support_radius = 2.6 * dx});
    Preset::Water water{{.density = 1000, .sound_speed = 10 * fastest, .viscosity = 1e-3}};
    Preset::set_coefficients(water);
    const auto pool = scene.add(water, sph::fill(sph::Box<2>({0, 0}, {width, height}), dx), dx);
    scene.add(Preset::Vessel{{.density = 1000}}, sph::tank(sph::Box<2>({0, 0}, {length, 1}), dx, 3, sph::Sides::y_high),
              dx);
    Preset::set_coefficients(scene.coupling<Preset::Sides>(), water);
    std::printf("%s", sph::describe(scene).c_str());
    scene.run_until(end, sph::Progress(end, false), sph::Guard<2>({.lower = {-dx, -dx}, .upper = {length + dx, 1}}),
                    sph::every(0.05, sph::Snapshots("out-from-a-preset")));

    const double front = scene[pool][sph::position].col(0).maxCoeff();
    std::printf("after %g s the front is at %.2f m, in shallow-water theory before %.2f m\n", end, front,
                width + fastest * end);
    return front > width + 0.4 * fastest * end && front < width + fastest * end ? 0 : 1;
}
