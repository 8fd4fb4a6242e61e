// A sponge whose underside touches water drinks it up through its pores, against its weight.
//
// The slab of the paper, 35 x 7 x 4 mm of it, periodic along y, soft and held at both ends, in a closed box half full
// of water. Above it is a gas, ten times lighter (air would be 800 times). Where the water wets the sponge, with a
// contact angle below 90 degrees, it rises in the pores. It is ten times as viscous as water is, so that it stops where
// they end: else drops come loose there that are single particles.
//
//   build/drinking_sponge               then open out-drinking-sponge/water.pvd and sponge.pvd in ParaView
//   build/drinking_sponge 120           with a contact angle of 120 instead of 45 degrees
//   build/drinking_sponge 45 1.5        with pores of 1.5 instead of 2 mm in radius
//   build/drinking_sponge 45 2 0.5      with a spacing of 0.5 instead of 0.35 mm
//   python3 tools/render_sponge.py out-drinking-sponge --times 0 6 12 30 -o drinking_sponge.png
#include "support/arguments.hpp"
#include "support/quiet_waiting.hpp"

#include <imbibe/imbibe.hpp>
#include <imbibe/presets/paper_slab.hpp>
#include <imbibe/presets/sponge_in_two_liquids.hpp>

#include <cstdio>

namespace sph = imbibe;
using Preset = sph::presets::SpongeInTwoLiquids;
using Scene = Preset::Scene<3, float>;

int main(int, char** argv) {
    sph::example::sleep_while_waiting(argv);
    try {
        const double degrees = sph::example::number(argv, 1, "the contact angle in degrees", 45, 0, 180);
        const double radius = 1e-3 * sph::example::number(argv, 2, "the radius of the pores in mm", 2, 0.7, 2.5);
        const double dx = 1e-3 * sph::example::number(argv, 3, "the spacing in mm", 0.35, 0.2, 0.5);
        const double g = 9.81, end = 0.03, sound = 4, light = 100, fine = 0.5e-3, length = 35e-3, width = 7e-3,
                     top = 4e-3;
        const double above = 28 * dx, below = -17 * dx, beside = 14 * dx, level = 3 * dx;

        const sph::presets::PaperSlab numbers{.pore_radius = radius, .spacing = fine, .rows = 1};
        const auto slab = sph::presets::paper_slab(numbers);
        const sph::Box<3> inside{{-beside, 0, below}, {length + beside, width, above}};
        std::vector<sph::Point<3>> in_water, in_gas;
        for (const auto& x : sph::fill(inside, dx)) // the slab's particles lie on its faces and reach beyond them
            if (x[2] < -fine / 2 || x[2] > top + fine / 2 || !slab.contains({x[0], x[1], top / 2}))
                (x[2] < level ? in_water : in_gas).push_back(x);

        Scene scene({.gravity = {0, 0, -g},
                     .support_radius = 3 * dx,
                     .periodic_lower = {-beside, 0, 0},
                     .periodic_length = {length + 2 * beside, width, 0}});
        const Preset::Interface interface {
            .surface_tension = 0.072, .contact_angle = degrees * std::numbers::pi / 180
        };
        Preset::Water water{{.density = 1000, .sound_speed = sound, .viscosity = 10e-3}};
        Preset::Oil gas{{.density = light, .sound_speed = sound * std::sqrt(1000 / light), .viscosity = 0.7e-3}};
        Preset::set_coefficients(water, interface, dx);
        Preset::set_coefficients(gas, interface, dx);
        const auto drink = scene.add(water, sph::jitter<3>(in_water, 0.2 * dx, 1), dx);
        const auto air = scene.add(gas, sph::jitter<3>(in_gas, 0.2 * dx, 2), dx);
        const auto sponge =
            scene.add(Preset::elastic(7e4, 0.3, 950, fine), sph::presets::paper_slab_particles(numbers), fine);
        scene.hold(sponge, [&](const auto& x) { return x[0] < 1e-3 || x[0] > length - 1e-3; });
        scene.add(Preset::Vessel{{.density = 1000}}, sph::tank(inside, dx, 3, sph::Sides::x | sph::Sides::y), dx);
        Preset::set_coefficients(scene, interface);
        sph::start_hydrostatic(scene, air, above);
        sph::start_hydrostatic(scene, drink, level, light * g * (above - level));
        std::printf("%s", sph::describe(scene).c_str());

        scene.run_until(end, sph::Progress(end, false), sph::every(1e-3, sph::Snapshots("out-drinking-sponge")));
        const auto now = scene[drink];
        double drunk = 0; // of the pores' volume
        for (int i = 0; i < now.size(); ++i)
            if (const auto x = now[sph::position].row(i); x[0] > 0 && x[0] < length && x[2] > 0 && x[2] < top)
                drunk += now[sph::mass](i) / now[sph::density](i) / (5 * std::numbers::pi * radius * radius * top);
        std::printf("%.0f %% of the pores are full of water, at a contact angle of %.0f degrees\n", 100 * drunk,
                    degrees);
    } catch (const sph::Error& error) {
        std::fprintf(stderr, "drinking_sponge: %s\n", error.what());
        return 2;
    }
}
