// Water drives oil out of a sponge: as a piston where the oil is thin, in fingers where it is thick.
//
// A sponge cut across its fibres, in two dimensions: 48 soft fibres of 1.2 mm, each held in its middle, in a channel
// that is periodic along the flow. A force along it, as gravity, drives both liquids, which have the same density. When
// the first water has come through, much of the oil is still in the pores if it is the more viscous one (Lenormand,
// Touboul and Zarcone 1988).
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
using Scene = Preset::Scene<2, float>;
using Point = sph::Point<2>;

int main(int, char** argv) {
    sph::example::sleep_while_waiting(argv);
    try {
        const double ratio = sph::example::number(argv, 1, "the viscosity of oil over that of water", 20, 0.05, 20);
        const double degrees = sph::example::number(argv, 2, "the contact angle in degrees", 60, 0, 180);
        const double dx = 1e-3 * sph::example::number(argv, 3, "the spacing in mm", 0.1, 0.05, 0.2);
        const double radius = 0.6e-3, across = 12e-3, before = 12e-3, bed = 16e-3, behind = 2e-3;
        const double tension = 0.03, sound = 2.5, force = 10, thick = 0.02, end = 0.6, E = 2e4, nu = 0.3;

        // Fibres in rows, each moved by a little at random.
        std::vector<Point> centres;
        for (int column = 0; column < 8; ++column)
            for (int row = 0; row < 6; ++row)
                centres.push_back({before + (column + 0.5) * 2e-3, (row + (column % 2 == 0 ? 0.3 : 0.7)) * 2e-3});
        centres = sph::jitter<2>(centres, 0.25e-3, 3);
        std::vector<Point> in_sponge, in_water, in_oil;
        const double length = before + bed + behind;
        double pores = bed * across;
        for (const auto& x : sph::fill(sph::Box<2>{{0, 0}, {length, across}}, dx)) {
            const bool solid = std::ranges::any_of(centres, [&](const Point& c) { return (x - c).norm() < radius; });
            pores -= solid ? dx * dx : 0;
            (solid ? in_sponge : x[0] < before ? in_water : in_oil).push_back(x);
        }

        Scene scene({.gravity = {force, 0}, .support_radius = 3 * dx, .periodic_length = {length, 0}});
        const Preset::Interface interface {
            .surface_tension = tension, .contact_angle = degrees * std::numbers::pi / 180
        };
        Preset::Water water{{.density = 1000, .sound_speed = sound, .viscosity = ratio > 1 ? thick / ratio : thick}};
        Preset::Oil oil{{.density = 1000, .sound_speed = sound, .viscosity = ratio > 1 ? thick : thick * ratio}};
        Preset::set_coefficients(water, interface, dx);
        Preset::set_coefficients(oil, interface, dx);
        const auto driving = scene.add(water, sph::jitter<2>(in_water, 0.2 * dx, 1), dx);
        const auto driven = scene.add(oil, sph::jitter<2>(in_oil, 0.2 * dx, 2), dx);
        const auto fibres = scene.add(Preset::Sponge{{.density = 1000,
                                                      .sound_speed = sph::sound_speed_of(E, nu, 1000),
                                                      .shear_modulus = sph::shear_modulus_of(E, nu),
                                                      .support_radius = 2 * dx}},
                                      in_sponge, dx);
        scene.hold(fibres, [&](const auto& x) {
            return std::ranges::any_of(centres, [&](const Point& c) { return (x - c).norm() < radius / 3; });
        });
        scene.add(Preset::Vessel{{.density = 1000}},
                  sph::tank(sph::Box<2>{{0, 0}, {length, across}}, dx, 3, sph::Sides::x), dx);
        Preset::set_coefficients(scene, interface);
        std::printf("%s", sph::describe(scene).c_str());

        // How far the first water has come, and which share of the oil has left the pores
        const auto farthest = [&] {
            const auto x = scene[driving][sph::position];
            double far = 0;
            for (int i = 0; i < x.rows(); ++i)
                if (x(i, 0) < length - behind / 2) // what is beyond is the water's rear, through the periodic side
                    far = std::max<double>(far, x(i, 0));
            return far;
        };
        const auto driven_out = [&] {
            const auto now = scene[driven];
            double left = 0;
            for (int i = 0; i < now.size(); ++i)
                if (now[sph::position](i, 0) > before && now[sph::position](i, 0) < before + bed)
                    left += now[sph::mass](i) / now[sph::density](i);
            return 1 - left / pores;
        };
        sph::Snapshots snapshots("out-oil-in-sponge");
        sph::Table table("out-oil-in-sponge/oil_in_sponge.csv", {{"time", "s"}, {"driven out", "1"}});
        sph::Progress progress(end, false);
        snapshots(scene);
        while (scene.time() < end && farthest() < before + bed) {
            scene.run_until(scene.time() + 5e-3, progress);
            table.row({scene.time(), driven_out()});
            snapshots(scene);
        }
        std::printf("After %.2f s %s, and %.0f %% of the oil is out of the pores.\n", scene.time(),
                    farthest() < before + bed ? "no water is through" : "the first water is through",
                    100 * driven_out());
    } catch (const sph::Error& error) {
        std::fprintf(stderr, "oil_in_sponge: %s\n", error.what());
        return 2;
    }
}
