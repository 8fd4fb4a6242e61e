// Water pushes a rubber gate open, in two dimensions: the gate that docs/peers.md describes for other codes, and the
// report of it. Measured: how far aside its lower end is at three times of the experiment of Antoci, Gallati and
// Sibilla (2007), m. A step is one of the water; the gate takes several shorter ones meanwhile.
//
//   build-benchmark/benchmarks/peers_elastic_gate float         on one thread, with a spacing of 1 mm
//   build-benchmark/benchmarks/peers_elastic_gate double 2 0.5  on two, with 0.5 mm
#include "report.hpp"

#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/methods/weakly_compressible.hpp>
#include <imbibe/monitor/displacement.hpp>
#include <imbibe/solid/bending_modulus.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/subcycled.hpp>

#include <functional>

namespace {

using namespace imbibe;
using K = WendlandC2;

struct Water : Fluid<LinearState, WeaklyCompressible<K>, MonaghanViscosity<K>> {};
struct Gate : Solid<TotalLagrangianSolid<StVenantKirchhoff, K>, Clamped, TimeAveragedMotion> {};
struct Tank : Wall<> {};
struct Push : CouplingOf<Water, Gate> {};
struct Contact : CouplingOf<Water, Tank> {};

} // namespace

int main(int argc, char** argv) {
    return peers::main_of(argc, argv, 1, 0.25, []<class Real>(int threads, double dx) {
        using Scene = Solver<2, Real, Subcycled<Gate>, Water, Gate, Tank, Push, Contact>;
        const double depth = 0.14, width = 0.1, thickness = 5e-3, length = 0.4, root = dx / 2 + 79e-3;
        Scene scene({.gravity = {0, -9.81}, .support_radius = 2.6 * dx, .search_interval = 4, .threads = threads});
        Water water{{.density = 1000, .sound_speed = 10 * std::sqrt(2 * 9.81 * depth)}};
        water.set(MonaghanViscosityParameters{.alpha = 0.02});
        const auto pool = scene.add(water, fill(Box<2>{{0, 0}, {width, depth}}, dx), dx);
        const double E = bending_modulus(7.8e6, static_cast<int>(std::lround(thickness / dx))), nu = 0.47;
        Gate rubber{
            {.density = 1100, .sound_speed = sound_speed_of(E, nu, 1100), .shear_modulus = shear_modulus_of(E, nu)}};
        rubber.support_radius = 1.5 * dx;
        const auto gate = scene.add(rubber, fill(Box<2>{{width, dx / 2}, {width + thickness, root + 3 * dx}}, dx), dx);
        scene.hold(gate, [&](const auto& x) { return x[1] > root; });
        auto walls = tank(Box<2>{{0, 0}, {length, 0.2}}, dx, 3, Sides::y_high);
        for (const auto& x : fill(Box<2>{{width, root + 3 * dx}, {width + thickness, 0.2}}, dx))
            walls.push_back(x);
        scene.add(Tank{{.density = 1000}}, walls, dx);
        scene.template coupling<Push>().set(PressureExtrapolationParameters{.suction = false});
        scene.template coupling<Contact>().set(PressureExtrapolationParameters{.suction = false});
        const DisplacementProbe<2> probe(scene[gate]);

        peers::Meter<Scene> meter;
        const auto aside = [&](double time) {
            scene.run_until(time, std::ref(meter), [&](Scene& s) {
                s.remove_if(pool, [&](const auto& x) { return x[0] > length - 2 * dx; });
            });
            return probe.mean_vector(scene[gate], [&](const auto& x) { return x[1] < 1.5 * dx; })[0];
        };
        const double first = aside(0.08), second = aside(0.119);
        meter.print("elastic_gate", scene, Real{}, dx, {first, second, aside(0.16)});
    });
}
