// Water falls on a gyroid, a sponge of one smooth strut without end, and drains through it, in three dimensions.
//
// The composition is that of the sponge (presets/sound_sponge.hpp); only the shape is another: Schoen's gyroid
// (1970) in cells of 10 mm, 0.35 of it solid, soft, its underside held. It is periodic to the sides, so that four cells
// stand for a layer of them.
//
//   build/gyroid                        then open out-gyroid/water.pvd and sponge.pvd in ParaView
//   build/gyroid 0.25                   with 0.25 of it solid
//   build/gyroid 0.35 1e5               with a Young's modulus of 1e5 instead of 2e4 Pa
//   python3 tools/render_space.py out-gyroid --times 0 40 70 150 --columns 4 -o gyroid.png
#include "support/arguments.hpp"
#include "support/quiet_waiting.hpp"

#include <imbibe/imbibe.hpp>
#include <imbibe/presets/sound_sponge.hpp>

#include <cstdio>

namespace sph = imbibe;
using Preset = sph::presets::SoundSponge;
using Scene = Preset::Scene<float>;

int main(int, char** argv) {
    sph::example::sleep_while_waiting(argv);
    try {
        const double cell = 10e-3, side = 2 * cell, fine = 0.5e-3, dx = cell / 16, gap = 2e-3, depth = 16 * dx;
        const double g = 9.81, end = 0.15, drain = 10e-3, fall = std::sqrt(2 * g * (depth + gap + cell + drain));
        const double fraction = sph::example::number(argv, 1, "the solid fraction", 0.35, 0.05, 0.95);
        const double E = sph::example::number(argv, 2, "Young's modulus in Pa", 2e4, 1e3, 1e12), nu = 0.3;

        Scene scene({.gravity = {0, 0, -g},
                     .support_radius = 2.6 * dx,
                     .cfl = 0.75,
                     .periodic_length = {side, side, 0},
                     .search_interval = 4});
        Preset::Water water{{.density = 1000, .sound_speed = 10 * fall, .viscosity = 1e-3}};
        Preset::set_coefficients(water);
        const double low = cell + gap;
        const auto pool = scene.add(water, sph::fill(sph::Box<3>{{0, 0, low}, {side, side, low + depth}}, dx), dx);
        const auto shape = sph::gyroid(sph::Box<3>{{0, 0, 0}, {side, side, cell}}, cell, fraction);
        std::printf("%s\n", sph::pore_report(shape, dx).sentence.c_str());
        const auto sponge = scene.add(Preset::Sponge{{.density = 950,
                                                      .sound_speed = sph::sound_speed_of(E, nu, 950),
                                                      .shear_modulus = sph::shear_modulus_of(E, nu),
                                                      .support_radius = 2 * fine}},
                                      sph::fill(shape, fine), fine);
        scene.hold(sponge, [&](const auto& x) { return x[2] < 2 * fine; });
        // A tray, to which nothing comes: water is taken away before.
        const double tray = drain + 4 * dx;
        scene.add(Preset::Vessel{{.density = 1000}},
                  sph::fill(sph::Box<3>{{0, 0, -tray - dx}, {side, side, -tray}}, dx), dx);
        Preset::set_coefficients(scene.coupling<Preset::Contact>(), water);
        Preset::set_coefficients(scene.coupling<Preset::Sides>(), water);
        std::printf("%s", sph::describe(scene).c_str());

        // What has gone through, and how far the sponge is pressed down meanwhile
        const int all = scene[pool].size();
        const sph::DisplacementProbe<3> probe(scene[sponge]);
        sph::Snapshots snapshots("out-gyroid");
        sph::Table table("out-gyroid/gyroid.csv", {{"time", "s"}, {"passed", "1"}, {"pressed down", "m"}});
        double passed = 0, deepest = 0;
        int left = 0;
        const auto measure = [&](const Scene& s) {
            const auto x = s[pool][sph::position];
            passed = static_cast<double>(left + (x.col(2).array() < 0).count()) / all;
            const double down = -probe.mean_vector(s[sponge])[2];
            deepest = std::max(deepest, down);
            table.row({s.time(), passed, down});
        };
        scene.run_until(end, sph::Progress(end, false), sph::every(10e-3, std::ref(snapshots)),
                        sph::every(1e-3, measure),
                        [&](Scene& s) { left += s.remove_if(pool, [&](const auto& x) { return x[2] < -drain; }); });
        std::printf("%.0f %% of the water is through; on average the gyroid gave way by up to %.2f mm\n", 100 * passed,
                    1e3 * deepest);
    } catch (const sph::Error& error) {
        std::fprintf(stderr, "gyroid: %s\n", error.what());
        return 2;
    }
}
