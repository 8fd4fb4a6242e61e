// A column of water collapses in two dimensions and runs along the floor: its front beside that of an experiment.
//
// After Koshizuka and Oka (1996): a column L wide and 2 L high at the end of a tank 4 L long, L = 0.146 m. Theirs is
// held by a gate that is pulled up, and rubs on the floor; this front is let go at once, slips, and is ahead.
//
//   build/dam_break_2d                  then open out-dam-break-2d/water.pvd in ParaView
//   build/dam_break_2d 64               with 64 instead of 32 particles across the column
//   python3 tools/render_plane.py out-dam-break-2d --times 100 200 300 400 --columns 4 -o dam_break_2d.png
#include "support/arguments.hpp"
#include "support/quiet_waiting.hpp"

#include <imbibe/imbibe.hpp>

#include <cstdio>

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<sph::LinearState, sph::WeaklyCompressible<K>, sph::MonaghanViscosity<K>> {};
struct Tank : sph::Wall<> {};
struct Contact : sph::CouplingOf<Water, Tank> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, Contact>;

int main(int, char** argv) {
    sph::example::sleep_while_waiting(argv);
    try {
        const double across = sph::example::number(argv, 1, "the number of particles across the column", 32, 4, 1000);
        const double L = 0.146, g = 9.81, dx = L / across, end = 0.7;
        Scene scene({.gravity = {0, -g}, .support_radius = 3 * dx});
        Water water{{.density = 1000, .sound_speed = 20 * std::sqrt(2 * g * L)}};
        water.set(sph::MonaghanViscosityParameters{.alpha = 0.02});
        const auto column = scene.add(water, sph::fill(sph::Box<2>{{0, 0}, {L, 2 * L}}, dx), dx);
        scene.add(Tank{{.density = 1000}}, sph::tank(sph::Box<2>{{0, 0}, {4 * L, 6 * L}}, dx, 3, sph::Sides::y_high),
                  dx);
        scene.coupling<Contact>().set(sph::PressureExtrapolationParameters{.suction = false});
        std::printf("%s", sph::describe(scene).c_str());

        // T = t sqrt(2 g/L) and Z = x/L of the experiment
        const double measured[][2]{{0.769, 1.252}, {1.153, 1.505}, {1.537, 1.892}, {1.935, 2.241},
                                   {2.323, 2.615}, {2.719, 3.003}, {3.096, 3.624}};
        auto snapshots = sph::every(0.02, sph::Snapshots("out-dam-break-2d"));
        std::printf("   T     front here  and there, in L\n");
        for (const auto& [T, Z] : measured) {
            scene.run_until(T * std::sqrt(L / (2 * g)), snapshots);
            const double front = scene[column][sph::position].col(0).maxCoeff() + dx / 2;
            std::printf("%5.3f    %5.3f       %5.3f  %+.0f %%\n", T, front / L, Z, 100 * (front / L / Z - 1));
        }

        // What the wall has turned upwards a little later: how much of the water has the energy to rise so high.
        scene.run_until(0.35, snapshots);
        const auto x = scene[column][sph::position], v = scene[column][sph::velocity];
        for (const double heights : {1.5, 2.0, 2.5, 3.2}) {
            const auto rises = (v.rowwise().squaredNorm().array() / (2 * g) + x.col(1).array()) > heights * 2 * L;
            std::printf("%.2f %% of the water can rise above %.1f heights of the column\n",
                        100.0 * static_cast<double>(rises.count()) / scene[column].size(), heights);
        }
        scene.run_until(end, sph::Progress(end, false), snapshots);
    } catch (const sph::Error& error) {
        std::fprintf(stderr, "dam_break_2d: %s\n", error.what());
        return 2;
    }
}
