// Water pushes a rubber gate open and flows out under it, in two dimensions.
//
// After Antoci, Gallati and Sibilla (2007): water 0.1 m wide and 0.14 m high behind a gate 79 mm high and 5 mm thick
// that hangs from a wall, held above that. In their experiment its lower end is 45 mm aside and 18 to 20 mm up at 0.13
// to 0.16 s, and about 30 and 10 mm at 0.4 s. Here, with a spacing of 1 mm, it is 42 mm aside and 14 mm up at 0.12 s,
// 30 and 7 mm at 0.4 s; with the softer rubber of later papers 46 and 18 mm at 0.13 s, 33 and 9 mm at 0.4 s.
//
// Rubber is stiff for its size: the gate takes some ten steps for one of the water (Subcycled).
//
//   build/elastic_gate                  then open out-elastic-gate/water.pvd and gate.pvd in ParaView
//   build/elastic_gate 0.5              with a spacing of 0.5 mm instead of 1 mm
//   build/elastic_gate 1 7.8e6 0.47     with the softer rubber: Young's modulus in Pa, Poisson's ratio
//   python3 tools/render_plane.py out-elastic-gate --times 40 80 120 240 -o gate.png
#include "support/arguments.hpp"
#include "support/quiet_waiting.hpp"

#include <imbibe/imbibe.hpp>

#include <cstdio>

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<sph::LinearState, sph::WeaklyCompressible<K>, sph::MonaghanViscosity<K>> {};
struct Gate : sph::Solid<sph::TotalLagrangianSolid<sph::StVenantKirchhoff, K>, sph::Clamped, sph::TimeAveragedMotion> {
};
struct Tank : sph::Wall<> {};
struct Push : sph::CouplingOf<Water, Gate> {};
struct Contact : sph::CouplingOf<Water, Tank> {};
using Scene = sph::Solver<2, float, sph::Subcycled<Gate>, Water, Gate, Tank, Push, Contact>;

int main(int, char** argv) {
    sph::example::sleep_while_waiting(argv);
    try {
        // Resolution
        const double dx = 1e-3 * sph::example::number(argv, 1, "the spacing in mm", 1, 0.1, 2.5), H = 2.6 * dx;
        const double width = 0.1, depth = 0.14, thickness = 5e-3, height = 79e-3, length = 0.4, end = 0.4;
        const double root = dx / 2 + height + 3 * dx; // held, above what is free to move

        // Water, gate, tank
        Scene scene({.gravity = {0, -9.81}, .support_radius = H, .search_interval = 4});
        Water water{{.density = 1000, .sound_speed = 10 * std::sqrt(2 * 9.81 * depth)}};
        water.set(sph::MonaghanViscosityParameters{.alpha = 0.02});
        const auto pool = scene.add(water, sph::fill(sph::Box<2>{{0, 0}, {width, depth}}, dx), dx);
        const double E = sph::example::number(argv, 2, "Young's modulus in Pa", 1.2e7, 1e4, 1e12),
                     nu = sph::example::number(argv, 3, "Poisson's ratio", 0.4, 0, 0.499);
        const auto gate = scene.add(Gate{{.density = 1100,
                                          .sound_speed = sph::sound_speed_of(E, nu, 1100),
                                          .shear_modulus = sph::shear_modulus_of(E, nu)}},
                                    sph::fill(sph::Box<2>{{width, dx / 2}, {width + thickness, root}}, dx), dx);
        scene.hold(gate, [&](const auto& x) { return x[1] > dx / 2 + height; });
        auto walls = sph::tank(sph::Box<2>{{0, 0}, {length, 0.2}}, dx, 3, sph::Sides::y_high);
        for (const auto& x : sph::fill(sph::Box<2>{{width, root}, {width + thickness, 0.2}}, dx))
            walls.push_back(x);
        scene.add(Tank{{.density = 1000}}, walls, dx);
        const sph::PressureExtrapolationParameters no_suction{.suction = false};
        scene.coupling<Push>().set(no_suction);
        scene.coupling<Contact>().set(no_suction);
        std::printf("%s", sph::describe(scene).c_str());

        // The way of the gate's lower end
        sph::Snapshots snapshots("out-elastic-gate");
        sph::Table table("out-elastic-gate/gate.csv", {{"time", "s"}, {"sideways", "m"}, {"up", "m"}});
        const sph::DisplacementProbe<2> probe(scene[gate]);
        const auto tip = [&](const Scene& s) {
            const auto moved = probe.mean_vector(s[gate], [&](const auto& x) { return x[1] < 1.5 * dx; });
            table.row({s.time(), moved[0], moved[1]});
        };
        scene.run_until(end, sph::Progress(end, false), sph::every(2e-3, tip), sph::every(0.02, std::ref(snapshots)),
                        [&](Scene& s) { s.remove_if(pool, [&](const auto& x) { return x[0] > length - 2 * dx; }); });
    } catch (const sph::Error& error) {
        std::fprintf(stderr, "elastic_gate: %s\n", error.what());
        return 2;
    }
}
