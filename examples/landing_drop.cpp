// A drop of water lands on a soft gel, spreads, draws back and comes to rest, with nothing around it.
//
// In the plane: a disc of 2 mm, at 0.4 m/s, on a gel 1 mm thick of 10 kPa that is bonded to a plate. The surface of the
// water has its tension (presets::WettingLiquid), and meets the gel at a given angle. At rest the drop is the part of a
// disc that has its area and meets the gel at that angle (Young 1805): that covers 2.83 mm at 90 degrees.
//
//   build/landing_drop                  then open out-landing-drop/water.pvd and sponge.pvd in ParaView
//   build/landing_drop 120              with a contact angle of 120 instead of 90 degrees
//   build/landing_drop 90 24            with 24 instead of 16 particles over the drop's radius
//   python3 tools/render_plane.py out-landing-drop --displaced sponge --times 2.5 4 8 60 --columns 2 -o landing_drop.png
#include "support/arguments.hpp"
#include "support/quiet_waiting.hpp"

#include <imbibe/imbibe.hpp>
#include <imbibe/presets/wetting_liquid.hpp>

#include <cstdio>

namespace sph = imbibe;
using Preset = sph::presets::WettingLiquid;
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Preset::Water, Preset::Sponge, Preset::On<Preset::Sponge>>;

int main(int, char** argv) {
    sph::example::sleep_while_waiting(argv);
    try {
        const double degrees = sph::example::number(argv, 1, "the contact angle in degrees", 90, 30, 150);
        const double across = sph::example::number(argv, 2, "the number of particles over the radius", 16, 8, 100);
        const double radius = 1e-3, wide = 8e-3, thick = 1e-3, speed = 0.4, end = 0.06, dx = radius / across;
        const double angle = degrees * std::numbers::pi / 180;

        Scene scene({.support_radius = 5 * dx, .periodic_lower = {-wide / 2, 0}, .periodic_length = {wide, 0}});
        const auto drop = scene.add(Preset::Water{{.density = 1000, .sound_speed = 10, .viscosity = 5e-3}},
                                    sph::fill(sph::Sphere<2>({0, radius + 7 * dx}, radius), dx), dx);
        const auto gel = scene.add(Preset::elastic(1e4, 0.4, 1000, dx),
                                   sph::fill(sph::Box<2>({-wide / 2, -thick - 3 * dx}, {wide / 2, 0}), dx), dx);
        scene.hold(gel, [&](const auto& x) { return x[1] < -thick; });
        const Preset::Interface interface { .surface_tension = 0.072, .contact_angle = angle };
        Preset::set_surface(scene[drop].material(), interface);
        Preset::set_contact_angle<Preset::Sponge>(scene, interface);
        const double begin = sph::settle_surface<Preset::Water>(scene);
        scene[drop][sph::velocity].col(1).setConstant(-speed);
        std::printf("%s", sph::describe(scene).c_str());

        const auto covered = [&] { // by the water within two spacings of the gel's face
            const auto x = scene[drop][sph::position];
            double from = 1, to = -1;
            for (int i = 0; i < x.rows(); ++i)
                if (x(i, 1) < 2 * dx)
                    from = std::min(from, x(i, 0)), to = std::max(to, x(i, 0));
            return std::max(0.0, to - from);
        };
        double most = 0;
        scene.run_until(begin + end, sph::Progress(begin + end, false),
                        sph::every(0.5e-3, sph::Snapshots("out-landing-drop")),
                        [&](const Scene&) { most = std::max(most, covered()); });
        const double segment = angle - std::sin(angle) * std::cos(angle); // of a disc of radius 1
        std::printf("the drop covered up to %.2f mm; it covers %.2f mm now, %.2f mm by Young's angle\n", 1e3 * most,
                    1e3 * covered(), 2e3 * radius * std::sin(angle) * std::sqrt(std::numbers::pi / segment));
    } catch (const sph::Error& error) {
        std::fprintf(stderr, "landing_drop: %s\n", error.what());
        return 2;
    }
}
