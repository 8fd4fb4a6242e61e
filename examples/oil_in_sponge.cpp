// Water drives oil out of a sponge: as a piston where the oil is thin, in fingers where it is thick.
//
// A sponge cut across its fibres, in two dimensions: 48 soft fibres of 1.2 mm, held in their middles, in a channel that
// is periodic along the flow. A force along it, as gravity, drives both liquids, which have the same density. When the
// first water is through, much of the oil is still there if it is the more viscous one (Lenormand, Touboul and Zarcone
// 1988).
//
//   build/oil_in_sponge                 oil 20 times as viscous as water: then open out-oil-in-sponge/*.pvd in ParaView
//   build/oil_in_sponge 0.05            a twentieth
//   build/oil_in_sponge 20 120          with a contact angle of 120 instead of 60 degrees, measured in the water
//   build/oil_in_sponge 20 60 0.15      with a spacing of 0.15 instead of 0.1 mm
//   python3 tools/render_plane.py out-oil-in-sponge --displaced sponge --walls vessel -o oil_in_sponge.png
#include "support/arguments.hpp"
#include "support/quiet_waiting.hpp"

#include <imbibe/imbibe.hpp>
#include <imbibe/presets/sponge_in_two_liquids.hpp>

#include <algorithm>
#include <cstdio>

namespace sph = imbibe;
using Preset = sph::presets::SpongeInTwoLiquids;
using Point = sph::Point<2>;

int main(int, char** argv) {
    sph::example::sleep_while_waiting(argv);
    try {
        const double ratio = sph::example::number(argv, 1, "the viscosity of oil over that of water", 20, 0.05, 20);
        const double degrees = sph::example::number(argv, 2, "the contact angle in degrees", 60, 0, 180);
        const double dx = 1e-3 * sph::example::number(argv, 3, "the spacing in mm", 0.1, 0.05, 0.2);
        const double radius = 0.6e-3, across = 12e-3, first = 12e-3, last = 28e-3, length = 30e-3; // of the bed
        const double rho = 1000, sound = 2.5, force = 10, thick = 0.02, end = 0.6;
        const double angle = degrees * std::numbers::pi / 180;
        const sph::Box<2> channel{{0, 0}, {length, across}};
        std::vector<Point> centres, in_sponge, in_water, in_oil; // of fibres in rows, each moved a little at random
        for (int n = 0; n < 48; ++n)
            centres.push_back({first + (n / 6 + 0.5) * 2e-3, (n % 6 + (n / 6 % 2 == 0 ? 0.3 : 0.7)) * 2e-3});
        centres = sph::jitter<2>(centres, 0.25e-3, 3);
        const auto near_centre = [&](const Point& x, double r) {
            return std::ranges::any_of(centres, [&](const Point& centre) { return (x - centre).norm() < r; });
        };
        for (const auto& x : sph::fill(channel, dx))
            (near_centre(x, radius) ? in_sponge : x[0] < first ? in_water : in_oil).push_back(x);
        const double pores = (last - first) * across - dx * dx * static_cast<double>(in_sponge.size());
        Preset::Scene<2, float> scene(
            {.gravity = {force, 0}, .support_radius = 3 * dx, .periodic_length = {length, 0}});
        const Preset::Interface interface { .surface_tension = 0.03, .contact_angle = angle };
        Preset::Water water{{.density = rho, .sound_speed = sound, .viscosity = thick * std::min(1.0, 1 / ratio)}};
        Preset::Oil oil{{.density = rho, .sound_speed = sound, .viscosity = thick * std::min(1.0, ratio)}};
        Preset::set_coefficients(water, interface, dx);
        Preset::set_coefficients(oil, interface, dx);
        const auto driving = scene.add(water, sph::jitter<2>(in_water, 0.2 * dx, 1), dx);
        const auto driven = scene.add(oil, sph::jitter<2>(in_oil, 0.2 * dx, 2), dx);
        const auto fibres = scene.add(Preset::elastic(2e4, 0.3, rho, dx), in_sponge, dx);
        scene.hold(fibres, [&](const auto& x) { return near_centre({x[0], x[1]}, radius / 3); });
        scene.add(Preset::Vessel{{.density = rho}}, sph::tank(channel, dx, 3, sph::Sides::x), dx);
        Preset::set_coefficients(scene, interface);
        std::printf("%s", sph::describe(scene).c_str());

        const auto through = [&] { // what is behind the last millimetre is the water's rear, through the periodic side
            const auto x = scene[driving][sph::position].col(0).cast<double>().array();
            return (x > last && x < length - 1e-3).any();
        };
        sph::Snapshots snapshots("out-oil-in-sponge");
        for (snapshots(scene); scene.time() < end && !through(); snapshots(scene))
            scene.run_until(scene.time() + 5e-3, sph::Progress(end, false));
        const auto now = scene[driven];
        double left = 0;
        for (int i = 0; i < now.size(); ++i)
            if (const double x = now[sph::position](i, 0); x > first && x < last)
                left += now[sph::mass](i) / now[sph::density](i) / pores;
        std::printf("After %.2f s %s, and %.0f %% of the oil is out of the pores.\n", scene.time(),
                    through() ? "the first water is through" : "no water is through", 100 * (1 - left));
    } catch (const sph::Error& error) {
        std::fprintf(stderr, "oil_in_sponge: %s\n", error.what());
        return 2;
    }
}
