// A column of water collapses in a tank: the dam break that docs/peers.md describes for other codes, and the report of
// it. Measured: how far from the wall behind the water its front is after 0.2 and 0.3 s, m.
//
//   build-benchmark/benchmarks/peers_dam_break float             on one thread, with a spacing of 1/110 m
//   build-benchmark/benchmarks/peers_dam_break double 2 20       on two, with 20 mm
#include "report.hpp"

#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/methods/weakly_compressible.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/tait.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <functional>

namespace {

using namespace imbibe;
using K = WendlandC2;

struct Water : Fluid<Tait<7>, WeaklyCompressible<K>, MonaghanViscosity<K>> {};
struct Tank : Wall<> {};
struct Contact : CouplingOf<Water, Tank> {};

} // namespace

int main(int argc, char** argv) {
    return peers::main_of(argc, argv, 1e3 / 110, 2, []<class Real>(int threads, double dx) {
        using Scene = Solver<3, Real, SymplecticEuler, Water, Tank, Contact>;
        Scene scene({.gravity = {0, 0, -9.81},
                     .support_radius = 2.6 * dx,
                     .search_interval = 100,
                     .search_skin = 0.1,
                     .threads = threads});
        Water water{{.density = 1000, .sound_speed = 45}};
        water.set(MonaghanViscosityParameters{.alpha = 0.02, .beta = 1});
        const auto column = scene.add(water, fill(Box<3>({0, 0, 0}, {0.5, 0.3, 0.5}), dx), dx);
        scene.add(Tank{{.density = 1000}}, tank(Box<3>({0, 0, 0}, {1.6, 0.3, 0.8}), dx, 3, Sides::z_high), dx);
        const auto front = [&] { return static_cast<double>(scene[column][position].col(0).maxCoeff()) + dx / 2; };

        peers::Meter<Scene> meter;
        scene.run_until(0.2, std::ref(meter));
        const double early = front();
        scene.run_until(0.3, std::ref(meter));
        meter.print("dam_break", scene, Real{}, dx, {early, front()});
    });
}
