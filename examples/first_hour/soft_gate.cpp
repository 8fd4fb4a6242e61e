// The dam break of docs/first_hour.md with one more phase: a strip of rubber that stands in the water's way.
//
//   build/first_hour_soft_gate            then open out-soft-gate/water.pvd, gate.pvd and tank.pvd in ParaView
//   build/first_hour_soft_gate 0.005      with particles 5 mm apart instead of 10 mm
#include <imbibe/imbibe.hpp>

#include <cstdlib>

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<sph::LinearState, sph::WeaklyCompressible<K>, sph::MonaghanViscosity<K>> {};
struct Gate : sph::Solid<sph::TotalLagrangianSolid<sph::StVenantKirchhoff, K>, sph::Clamped> {};
struct Tank : sph::Wall<> {};
struct Contact : sph::CouplingOf<Water, Tank> {};
struct Push : sph::CouplingOf<Water, Gate> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Gate, Tank, Contact, Push>;

int main(int argc, char** argv) {
    const double dx = argc > 1 ? std::atof(argv[1]) : 0.01, end = 0.5, thickness = 0.02, height = 0.1, E = 2e5,
                 nu = 0.4;
    sph::require(dx > 0 && dx <= 0.03, "the spacing of the particles, '", argc > 1 ? argv[1] : "",
                 "', must be a number above 0 and at most 0.03 m, as in 0.005");
    const sph::Box<2> column{{0, 0}, {0.2, 0.4}}, room{{0, 0}, {0.8, 0.6}};

    Scene scene({.gravity = {0, -9.81}, .support_radius = 2.6 * dx});
    Water water{{.density = 1000, .sound_speed = 28}};
    water.set(sph::MonaghanViscosityParameters{.alpha = 0.02, .beta = 1});
    scene.add(water, sph::fill(column, dx), dx);
    scene.add(Tank{{.density = 1000}}, sph::tank(room, dx, 3), dx);

    // Four particles across the gate, the lowest two layers held.
    const double fine = thickness / 4;
    const sph::Box<2> strip{{0.4, 0}, {0.4 + thickness, height}};
    const auto gate = scene.add(Gate{{.density = 1100,
                                      .sound_speed = sph::sound_speed_of(E, nu, 1100),
                                      .shear_modulus = sph::shear_modulus_of(E, nu),
                                      .support_radius = 1.5 * fine}},
                                sph::fill(strip, fine), fine);
    scene.hold(gate, [&](const auto& x) { return x[1] < 2 * fine; });

    const sph::PressureExtrapolationParameters no_suction{.suction = false};
    scene.coupling<Contact>().set(no_suction);
    scene.coupling<Push>().set(no_suction);
    std::printf("%s", sph::describe(scene).c_str());

    scene.run_until(end, sph::Progress(end, false), sph::Guard<2>({.lower = {-0.1, -0.1}, .upper = {0.9, 0.7}}),
                    sph::every(0.02, sph::Snapshots("out-soft-gate")));
}
