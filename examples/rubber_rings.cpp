// Two rubber rings collide and rebound as whole rings, in two dimensions: what holds them together is the artificial
// stress. The rings are the example of Gray, Monaghan and Swift (2001): radii 3 and 4 cm, Poisson's ratio 0.3975, each
// at 0.059 of the speed of sound. Without the artificial stress they go to pieces.
//
//   build/rubber_rings                  then open out-rubber-rings/rings.pvd in ParaView
//   build/rubber_rings 0.5              with a spacing of 0.5 mm instead of 1 mm
//   build/rubber_rings 1 0              without the artificial stress: the second number is its epsilon, else 0.3
//   python3 tools/render_plane.py out-rubber-rings --fluid rings --times 0 6 12 30 -o rings.png
#include "support/arguments.hpp"
#include "support/quiet_waiting.hpp"

#include <imbibe/imbibe.hpp>

#include <cstdio>

namespace sph = imbibe;
using K = sph::CubicSpline; // that of the paper

struct Rings : sph::Solid<sph::LinearState, sph::Continuity<K>, sph::VelocityGradient<K>, sph::JaumannStress,
                          sph::StressForce<K>, sph::ArtificialStress<K>, sph::MonaghanViscosity<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Rings>;

int main(int, char** argv) {
    sph::example::sleep_while_waiting(argv);
    try {
        const double dx = 1e-3 * sph::example::number(argv, 1, "the spacing in mm", 1, 0.1, 5);
        const double epsilon = sph::example::number(argv, 2, "epsilon of the artificial stress", 0.3, 0, 1);
        const double inner = 0.03, outer = 0.04, E = 2e6, nu = 0.3975, rho = 1000, end = 0.03;

        Scene scene({.support_radius = 2.6 * dx});
        Rings rubber{{.density = rho,
                      .sound_speed = sph::sound_speed_of(E, nu, rho),
                      .shear_modulus = sph::shear_modulus_of(E, nu)}};
        rubber.set(sph::ArtificialStressParameters{.epsilon = epsilon});
        rubber.set(sph::MonaghanViscosityParameters{.alpha = 0.5, .beta = 0.5});
        const auto ring = [&](double x) {
            const sph::Point<2> centre(x, 0);
            return sph::fitted(sph::Sphere<2>{centre, outer} - sph::Sphere<2>{centre, inner}, dx);
        };
        scene.add(rubber, ring(-0.0445), dx);
        const auto rings = scene.add(rubber, ring(0.0445), dx);
        auto view = scene[rings];
        const double speed = 0.059 * rubber.sound_speed;
        for (int i = 0; i < view.size(); ++i)
            view[sph::velocity](i, 0) = view[sph::position](i, 0) < 0 ? speed : -speed;
        std::printf("%s", sph::describe(scene).c_str());

        const double energy = sph::kinetic_energy(view);
        scene.run_until(end, sph::Progress(end, false), sph::every(5e-4, sph::Snapshots("out-rubber-rings")));

        // How the ring that came from the left leaves: its particles were added first.
        double leaving = 0;
        for (int i = 0; i < view.size(); ++i)
            if (view.ids()[static_cast<std::size_t>(i)] < static_cast<unsigned>(view.size() / 2))
                leaving -= 2 * view[sph::velocity](i, 0) / view.size();
        std::printf("each came with %.3f m/s and leaves with %.3f m/s; %.0f %% of the energy is still in motion\n",
                    speed, leaving, 100 * sph::kinetic_energy(view) / energy);
    } catch (const sph::Error& error) {
        std::fprintf(stderr, "rubber_rings: %s\n", error.what());
        return 2;
    }
}
