// Half a metre of water on a soft elastic plate, in two dimensions: the plate sinks to where it carries the water.
//
// After Fourey et al. (2017), with a plate a hundred times softer and a quarter of the water: one
// metre of it, 0.05 m thick, held at both ends. Two-dimensional elasticity says that its middle hangs down by 2.10 mm
// (within 4 %); here it is 2.32 mm with 5 particles across the plate, which alone are 11 % too soft, and with 10
// 2.18 mm (tests/validation/more/test_plate_couplings.cpp asks for the 4 % with 10). The motion is damped, so that the
// run ends at rest.
//
//   build/soft_plate                    then open out-soft-plate/water.pvd and plate.pvd in ParaView
//   build/soft_plate 10                 with a plate of 10 instead of 5 particles across
//   python3 tools/render_plane.py out-soft-plate --walls sides --displaced plate --times 20 100 -o soft_plate.png
#include "support/arguments.hpp"
#include "support/quiet_waiting.hpp"

#include <imbibe/imbibe.hpp>

#include <cstdio>

namespace sph = imbibe;
using K = sph::WendlandC2;

// Without the floor of the density: the water is at rest and nowhere torn.
struct Water : sph::Fluid<sph::LinearState, sph::WeaklyCompressible<K>, sph::Instead<sph::DensityFloor>,
                          sph::MonaghanViscosity<K>> {};
struct Plate : sph::Solid<sph::TotalLagrangianSolid<sph::StVenantKirchhoff, K>, sph::Clamped> {};
struct Sides : sph::Wall<> {};
struct Load : sph::CouplingOf<Water, Plate> {};
struct Tank : sph::CouplingOf<Water, Sides> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Plate, Sides, Load, Tank>;

int main(int, char** argv) {
    sph::example::sleep_while_waiting(argv);
    try {
        const double depth = 0.5, thickness = 0.05, g = 9.81, dx = 0.02, damping = 120, end = 0.1;
        const double across = sph::example::number(argv, 1, "the number of particles across the plate", 5, 2, 100);
        const double fine = thickness / across, E = 6.75e8, nu = 0.34;

        Scene scene({.gravity = {0, -g}, .support_radius = 3 * dx});
        Water water{{.density = 1000, .sound_speed = 10 * std::sqrt(2 * g * depth)}};
        water.set(sph::MonaghanViscosityParameters{.alpha = 0.05});
        const auto pool = scene.add(water, sph::fill(sph::Box<2>{{0, 0}, {1, depth}}, dx), dx);
        auto fluid = scene[pool];
        for (int i = 0; i < fluid.size(); ++i) // water at rest
            fluid[sph::density](i) += 1000 * g * (depth - fluid[sph::position](i, 1)) / sph::sq(water.sound_speed);
        const auto plate = scene.add(Plate{{.density = 2700,
                                            .sound_speed = sph::sound_speed_of(E, nu, 2700),
                                            .shear_modulus = sph::shear_modulus_of(E, nu),
                                            .support_radius = 1.5 * fine}},
                                     sph::fill(sph::Box<2>{{-4 * fine, -thickness}, {1 + 4 * fine, 0}}, fine), fine);
        scene.hold(plate, [](const auto& x) { return x[0] < 0 || x[0] > 1; });
        auto sides = sph::fill(sph::Box<2>{{-3 * dx, 0}, {0, 1.2 * depth}}, dx);
        for (const auto& x : sph::fill(sph::Box<2>{{1, 0}, {1 + 3 * dx, 1.2 * depth}}, dx))
            sides.push_back(x);
        scene.add(Sides{{.density = 1000}}, sides, dx);
        std::printf("%s", sph::describe(scene).c_str());

        auto solid = scene[plate];
        double before = 0;
        scene.run_until(end, sph::Progress(end, false), sph::every(0.02, sph::Snapshots("out-soft-plate")),
                        [&](Scene& s) {
                            const double left = 1 - damping * (s.time() - before);
                            solid[sph::velocity] *= left;
                            fluid[sph::velocity] *= left;
                            before = s.time();
                        });
        const auto x = solid[sph::position], X = solid[sph::reference_position];
        double sag = 0;
        for (int i = 0; i < solid.size(); ++i)
            sag = std::max(sag, X(i, 1) - x(i, 1));
        std::printf("the plate hangs down by %.2f mm; elasticity says 2.10 mm\n", 1e3 * sag);
    } catch (const sph::Error& error) {
        std::fprintf(stderr, "soft_plate: %s\n", error.what());
        return 2;
    }
}
