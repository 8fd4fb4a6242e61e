// Water that comes and goes: a jet hits a plate, is fed as long as it runs, and leaves at both ends of the plate. The
// plate feels rho v^2 times the width of the jet, by the balance of momentum.
//
//   build/guide_inflow; python3 tools/render_plane.py out-inflow --times 100 200 1000 --columns 3 -o inflow.png
#include <imbibe/imbibe.hpp>

#include <cstdio>

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<sph::LinearState, sph::WeaklyCompressible<K>, sph::MonaghanViscosity<K>> {};
struct Plate : sph::Wall<> {};
struct Contact : sph::CouplingOf<Water, Plate, sph::Into<Plate, sph::ReactionForce<sph::VolumePressure<K>>>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Plate, Contact>;

int main() {
    const double dx = 0.01, width = 0.1, speed = 2, end = 1.5, to_the_plate = 0.4, half = 0.4, drained = 0.3;
    Scene scene({.support_radius = 2.6 * dx});
    Water water{{.density = 1000, .sound_speed = 15 * speed}};
    water.set(sph::MonaghanViscosityParameters{.alpha = 0.02, .beta = 1});
    const auto plate = scene.add(Plate{{.density = 1000}},
                                 sph::fill(sph::Box<2>({to_the_plate, -half}, {to_the_plate + 3 * dx, half}), dx), dx);

    // A column of the jet comes in at x = 0 whenever the one before has made room, with the speed of the jet.
    int columns = 0;
    const sph::PhaseHandle<Water> jet; // what `add` returns, too
    const auto feed = [&](Scene& s) {
        for (double x; (x = speed * s.time() - columns * dx) >= 0; ++columns) {
            const int before = s[jet].size();
            s.add(water, sph::fill(sph::Box<2>({x, -width / 2}, {x + dx, width / 2}), dx), dx);
            for (int i = before; i < s[jet].size(); ++i) // new particles are the last ones until the next step
                s[jet][sph::velocity](i, 0) = speed;
        }
    };
    // What runs along the plate is taken out before its ends, beyond which it would turn round them.
    auto drain =
        sph::every(0.01, [&](Scene& s) { s.remove_if(jet, [&](const auto& x) { return std::abs(x[1]) > drained; }); });
    double force = 0, steps = 0;
    const auto measure = [&](Scene& s) {
        if (s.time() > 0.7) { // the flow is steady
            force += s[plate][sph::reaction_force].col(0).sum();
            ++steps;
        }
    };
    scene.run_until(end, feed, drain, measure, sph::every(0.1, sph::Snapshots("out-inflow")));

    const double expected = water.density * speed * speed * width;
    std::printf("%d particles of water; force on the plate %.1f N/m, rho v^2 b = %.1f N/m\n", scene[jet].size(),
                force / steps, expected);
    return std::abs(force / steps / expected - 1) < 0.05 ? 0 : 1;
}
