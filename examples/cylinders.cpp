// Glycerine sinks through an array of bars by its own weight, in two dimensions: how much the array lets through.
//
// After Sangani and Acrivos (1982): a square array of cylinders, L apart, that fill a share c of the plane. The mean
// flow U, with the cylinders counted in, meets the drag F = rho g L^2 of each of them; for c = 0.05, 0.1, 0.2, 0.3 they
// have F/(mu U) = 15.56, 24.83, 51.53, 102.90, and the permeability is K = mu U/(rho g) = L^2/(F/(mu U)). The plane is
// periodic, so four cylinders stand for all. Particles of glycerine and cylinders are packed together and follow the
// surface; the continuity equation sees the velocity that the cylinders show (NoSlipContinuity).
//
//   build/cylinders                     then open out-cylinders/glycerine.pvd in ParaView
//   build/cylinders 0.3                 with cylinders that fill 0.3 of the plane instead of 0.2
//   build/cylinders 0.2 50              with 50 instead of 30 particles from one cylinder to the next
//   python3 tools/render_plane.py out-cylinders --fluid glycerine --walls cylinders --times 10 -o cylinders.png
#include "support/arguments.hpp"
#include "support/quiet_waiting.hpp"

#include <imbibe/imbibe.hpp>

#include <cstdio>

namespace sph = imbibe;
using K = sph::QuinticSpline;

struct Glycerine
    : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>, sph::MorrisViscosity<K>> {};
struct Cylinders : sph::Wall<> {};
struct Contact : sph::Coupling<Glycerine, Cylinders, sph::Into<Cylinders, sph::PressureExtrapolation<K>>,
                               sph::VolumePressure<K>, sph::Into<Glycerine, sph::NoSlipContinuity<K>>,
                               sph::Into<Cylinders, sph::NoSlipVelocity<K>>, sph::NoSlipViscosity<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Glycerine, Cylinders, Contact>;

int main(int, char** argv) {
    sph::example::sleep_while_waiting(argv);
    try {
        // A cylinder is two particles wide at least, and so is the gap to the next.
        const double across =
            sph::example::number(argv, 2, "the number of particles from one cylinder to the next", 30, 10, 1000);
        const double least = std::numbers::pi / sph::sq(across), most = std::numbers::pi * sph::sq(0.5 - 1 / across);
        const double c = sph::example::number(argv, 1, "the share of the plane that cylinders fill", 0.2, least, most);
        const double L = 5e-3, dx = L / across, rho = 1260, mu = 1, g = 9.81,
                     radius = L * std::sqrt(c / std::numbers::pi);
        const double time_of_friction = rho * L * L / mu, sound_speed = 100 * mu / (rho * L);

        Scene scene({.gravity = {0, -g}, .support_radius = 3 * dx, .periodic_length = {2 * L, 2 * L}});
        Glycerine liquid{{.density = rho, .sound_speed = sound_speed, .viscosity = mu}};
        const auto disc = [&](double x, double y) { return sph::Sphere<2>{{x * L, y * L}, radius}; };
        const auto discs = disc(0.5, 0.5) | disc(1.5, 0.5) | disc(0.5, 1.5) | disc(1.5, 1.5);
        const sph::Box<2> plane({0, 0}, {2 * L, 2 * L});
        const auto places = sph::fitted_together(dx, plane.lower(), 0, plane & discs, plane - discs);
        const auto glycerine = scene.add(liquid, places[1], dx);
        const auto cylinders = scene.add(Cylinders{{.density = rho}}, places[0], dx);
        const double share = dx * dx * scene[cylinders].size() / plane.volume();
        std::printf("%s", sph::describe(scene).c_str());

        // Until the mean flow has stopped growing
        sph::Snapshots snapshots("out-cylinders");
        snapshots.resume(scene, 0); // a new series, though its first snapshot comes later
        double U = 0;
        for (double before = -1; std::abs(U - before) > 3e-4 * U || U <= 0;) {
            before = U;
            scene.run_until(scene.time() + 0.02 * time_of_friction);
            U = -scene[glycerine][sph::velocity].col(1).sum() * dx * dx / plane.volume();
            snapshots(scene);
        }
        const double drag = rho * g * L * L / (mu * U), permeability = L * L / drag;
        std::printf("U = %.3g m/s after %.2g s, Re = %.2g; K = %.4g m^2 = %.4f of a cylinder's radius squared\n", U,
                    scene.time(), rho * U * L / mu, permeability, permeability / (radius * radius));
        std::printf("c = %.4f in particles: F/(mu U) = %.2f", share, drag);
        const double known[][2]{{0.05, 15.56}, {0.1, 24.83}, {0.2, 51.53}, {0.3, 102.90}};
        for (const auto& [fraction, reference] : known)
            if (std::abs(c - fraction) < 1e-9)
                std::printf("; Sangani and Acrivos have %.2f, %+.1f %%", reference, 100 * (drag / reference - 1));
        std::printf("\n");
    } catch (const sph::Error& error) {
        std::fprintf(stderr, "cylinders: %s\n", error.what());
        return 2;
    }
}
