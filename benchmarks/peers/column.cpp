// An elastic column stands on its foot when gravity begins, sags and rises again: the column that docs/peers.md
// describes for other codes, and the report of it. Measured: the greatest sag of its top, m, and when, s; a thin bar
// sags by rho g L^2/E after 2 L sqrt(rho/E).
//
//   build-benchmark/benchmarks/peers_column float               on one thread, with a spacing of 10 mm
//   build-benchmark/benchmarks/peers_column double 2 20         on two, with 20 mm
#include "report.hpp"

#include <imbibe/geometry/fill.hpp>
#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/monitor/displacement.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solid/total_lagrangian_viscosity.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <functional>

namespace {

using namespace imbibe;
using K = WendlandC2;

struct Rubber : Solid<TotalLagrangianSolid<StVenantKirchhoff, K>, TotalLagrangianViscosity<K>, Clamped> {};

} // namespace

int main(int argc, char** argv) {
    return peers::main_of(argc, argv, 10, 2.5, []<class Real>(int threads, double dx) {
        using Scene = Solver<3, Real, SymplecticEuler, Rubber>;
        Scene scene({.gravity = {0, 0, -9.81}, .support_radius = 2.6 * dx, .threads = threads});
        const Rubber rubber{{.density = 1000, .sound_speed = 30, .shear_modulus = 3e5}}; // E = 8.1e5 Pa, nu = 0.35
        const double foot = 3 * dx; // is held; wider than the support
        const auto column = scene.add(rubber, fill(Box<3>({0, 0, 0}, {0.2, 0.2, 1.0 + foot}), dx), dx);
        scene.hold(column, [&](const Point<3>& x) { return x[2] < foot; });
        const DisplacementProbe<3> probe(scene[column]);
        double sag = 0, when = 0;
        const auto look = [&](const Scene& s) {
            const auto moved = probe.mean_vector(s[column], [&](const auto& x) { return x[2] > 1.0 + foot - dx; });
            if (-moved[2] > sag) {
                sag = -moved[2];
                when = s.time();
            }
        };

        peers::Meter<Scene> meter;
        scene.run_until(0.06, std::ref(meter)); // the top is on its way down
        scene.run_until(0.08, std::ref(meter), look);
        meter.print("column", scene, Real{}, dx, {sag, when});
    });
}
