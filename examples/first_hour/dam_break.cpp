// The dam break of docs/first_hour.md, in two dimensions: a column of water collapses in a tank.
//
//   build/first_hour_dam_break            then open out-first-hour/water.pvd and tank.pvd in ParaView
//   build/first_hour_dam_break 0.005      with particles 5 mm apart instead of 10 mm
#include <imbibe/imbibe.hpp>

#include <cstdlib>

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<sph::LinearState, sph::WeaklyCompressible<K>, sph::MonaghanViscosity<K>> {};
struct Tank : sph::Wall<> {};
struct Contact : sph::CouplingOf<Water, Tank> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, Contact>;

int main(int argc, char** argv) {
    const double dx = argc > 1 ? std::atof(argv[1]) : 0.01, end = 1;
    sph::require(dx > 0 && dx <= 0.03, "the spacing of the particles, '", argc > 1 ? argv[1] : "",
                 "', must be a number above 0 and at most 0.03 m, as in 0.005");
    const sph::Box<2> column{{0, 0}, {0.2, 0.4}}, room{{0, 0}, {0.8, 0.6}};

    Scene scene({.gravity = {0, -9.81}, .support_radius = 2.6 * dx});
    Water water{{.density = 1000, .sound_speed = 28}};
    water.set(sph::MonaghanViscosityParameters{.alpha = 0.02, .beta = 1});
    scene.add(water, sph::fill(column, dx), dx);
    scene.add(Tank{{.density = 1000}}, sph::tank(room, dx, 3), dx);
    scene.coupling<Contact>().set(sph::PressureExtrapolationParameters{.suction = false});
    std::printf("%s", sph::describe(scene).c_str());

    scene.run_until(end, sph::Progress(end, false), sph::Guard<2>({.lower = {-0.1, -0.1}, .upper = {0.9, 0.7}}),
                    sph::every(0.02, sph::Snapshots("out-first-hour")));
}
