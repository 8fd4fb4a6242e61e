// The dam break of docs/first_hour.md with two changes: syrup in place of water, and a block in its way.
//
//   build/first_hour_syrup                then open out-syrup/syrup.pvd and tank.pvd in ParaView
//   build/first_hour_syrup 0.005          with particles 5 mm apart instead of 10 mm
#include <imbibe/imbibe.hpp>

#include <cstdlib>

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Syrup : sph::Fluid<sph::LinearState, sph::WeaklyCompressible<K>, sph::ClearyViscosity<K>> {};
struct Tank : sph::Wall<> {};
struct Contact : sph::CouplingOf<Syrup, Tank, sph::Into<Tank, sph::NoSlipVelocity<K>>, sph::NoSlipViscosity<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Syrup, Tank, Contact>;

int main(int argc, char** argv) {
    const double dx = argc > 1 ? std::atof(argv[1]) : 0.01, end = 1;
    sph::require(dx > 0 && dx <= 0.03, "the spacing of the particles, '", argc > 1 ? argv[1] : "",
                 "', must be a number above 0 and at most 0.03 m, as in 0.005");
    const sph::Box<2> column{{0, 0}, {0.2, 0.4}}, room{{0, 0}, {0.8, 0.6}}, block{{0.4, 0}, {0.46, 0.06}};

    Scene scene({.gravity = {0, -9.81}, .support_radius = 2.6 * dx});
    scene.add(Syrup{{.density = 1400, .sound_speed = 28, .viscosity = 10}}, sph::fill(column, dx), dx);
    auto walls = sph::tank(room, dx, 3);
    for (const auto& x : sph::fill(block, dx))
        walls.push_back(x);
    scene.add(Tank{{.density = 1400}}, walls, dx);
    scene.coupling<Contact>().set(sph::PressureExtrapolationParameters{.suction = false});
    std::printf("%s", sph::describe(scene).c_str());

    scene.run_until(end, sph::Progress(end, false), sph::Guard<2>({.lower = {-0.1, -0.1}, .upper = {0.9, 0.7}}),
                    sph::every(0.02, sph::Snapshots("out-syrup")));
}
