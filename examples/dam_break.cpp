// A column of water collapses in a tank. A scene of our own; dam_break_2d.cpp is that of an experiment.
//
//   build/dam_break                     then open out-dam-break/water.pvd in ParaView
//   python3 tools/render_space.py out-dam-break --times 200 400 700 940 -o dam_break.png
#include <imbibe/imbibe.hpp>
namespace sph = imbibe;
using K = sph::WendlandC2;

// WeaklyCompressible is the name of four terms, and brings what acts between such a fluid and a wall: `describe` lists them.
struct Water : sph::Fluid<sph::Tait<7>, sph::WeaklyCompressible<K>, sph::MonaghanViscosity<K>> {};
struct Tank : sph::Wall<> {};
struct Contact : sph::CouplingOf<Water, Tank> {};
using Scene = sph::Solver<3, double, sph::SymplecticEuler, Water, Tank, Contact>;

int main() {
    const double dx = 0.02, end = 1.0;
    // Neighbour lists have a 10 % skin and are reused until a particle may have crossed it.
    Scene scene({.gravity = {0, 0, -9.81}, .support_radius = 2.6 * dx, .search_interval = 100, .search_skin = 0.1});
    Water water{{.density = 1000, .sound_speed = 45}};
    water.set(sph::MonaghanViscosityParameters{.alpha = 0.02, .beta = 1});
    scene.add(water, sph::fill(sph::Box<3>({0, 0, 0}, {0.5, 0.3, 0.5}), dx), dx);
    scene.add(Tank{{.density = 1000}}, sph::tank(sph::Box<3>({0, 0, 0}, {1.6, 0.3, 0.8}), dx, 3, sph::Sides::z_high),
              dx);
    std::printf("%s", sph::describe(scene).c_str());
    scene.run_until(end, sph::Progress(end, true), sph::every(0.02, sph::Snapshots("out-dam-break")));
}
