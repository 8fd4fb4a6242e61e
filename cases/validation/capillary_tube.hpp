// Water that rises in a round tube, against its weight, and pushes out what was there.
//
// Reference: Jurin; in a tube of radius R beside an open area A that touches it along a circle of radius S, the levels
// differ by sigma cos theta/((rho - rho_o) g) (2/R - 2 pi S/A).
// Geometry: R = 1, a tube of 4 spacings, 0.6 from floor and ceiling, in a periodic square of 5; height 4, water up to
// 2; rho = sigma = 1, rho_o = 0.5, g = 2, viscosity 0.03 of both; the levels begin with half of the difference. Scheme:
// presets::TwoLiquids in float, from a lattice jittered by a fifth of a spacing; sound is 14. Measure: the mean level
// of water in the tube, by its volume, less that outside, from t = 10.5 to 14.
#pragma once

#include "case.hpp"

#include <imbibe/core/error.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/presets/two_liquids.hpp>
#include <imbibe/state/hydrostatic.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace validation::capillary_tube {

namespace sph = imbibe;
using Preset = sph::presets::TwoLiquids;
using Point = sph::Point<3>;

constexpr double width = 5, level = 2, height = 4, lowest = 0.6, lighter = 0.5, gravity = 2, pi = std::numbers::pi;

/// By how much the levels differ.
struct Rise {
    double found = 0; ///< mean over the end of the run
    double exact = 0; ///< Jurin's
};
/// @param across particles across the tube @param degrees the contact angle
inline Rise rise(double across, double degrees) {
    constexpr double end = 14;
    const double spacing = 2 / across, outer = 1 + 4 * spacing, outside = width * width - pi * outer * outer;
    const double angle = degrees * pi / 180;
    Rise rise{.exact = std::cos(angle) / ((1 - lighter) * gravity) * (2 - 2 * pi * outer / outside)};
    Preset::Scene<3, float> scene({.gravity = {0, 0, -gravity},
                                   .support_radius = 3 * spacing,
                                   .cfl = 0.4,
                                   .periodic_length = {width, width, 0},
                                   .threads = 1});
    const Preset::Interface interface { .surface_tension = 1, .contact_angle = angle };
    Preset::Water water{{.density = 1, .sound_speed = 14, .viscosity = 0.03}};
    Preset::Oil oil{{.density = lighter, .sound_speed = 14 / std::sqrt(lighter), .viscosity = 0.03}};
    Preset::set_coefficients(water, interface, spacing);
    Preset::set_coefficients(oil, interface, spacing);
    const auto from_axis = [](double x, double y) { return std::hypot(x - width / 2, y - width / 2); };
    const double step = 0.5 * rise.exact / (outside + pi); // half of the rise, at the same volume of water
    std::vector<Point> below, above, walls;
    const sph::Box<3> inside({0, 0, 0}, {width, width, height});
    for (const auto& x : sph::fill(inside, spacing)) {
        const double r = from_axis(x[0], x[1]), surface = r < 1 ? level + step * outside : level - step * pi;
        const bool in_tube = r > 1 && r < outer && x[2] > lowest && x[2] < height - lowest;
        (in_tube ? walls : x[2] < surface ? below : above).push_back(x);
    }
    const auto tank = sph::tank(inside, spacing, 4, sph::Sides::x | sph::Sides::y);
    walls.insert(walls.end(), tank.begin(), tank.end());
    const auto lower = scene.add(water, sph::jitter<3>(below, 0.2 * spacing, 1), spacing);
    const auto upper = scene.add(oil, sph::jitter<3>(above, 0.2 * spacing, 2), spacing);
    scene.add(Preset::Vessel{{.density = 1, .viscosity = 0.03}}, walls, spacing);
    Preset::set_coefficients(scene, interface);
    sph::start_hydrostatic(scene, upper, height);
    sph::start_hydrostatic(scene, lower, level, lighter * gravity * (height - level));
    int times = 0;
    scene.run_until(end, [&](const auto& s) {
        if (s.time() < 0.75 * end)
            return;
        const auto view = s[lower];
        const auto wrapped = [](double x) { return x - width * std::floor(x / width); };
        double within = 0, beside = 0;
        for (int i = 0; i < view.size(); ++i) {
            const auto x = view[sph::position].row(i);
            if (x[2] < lowest + 3 * spacing)
                continue; // below and just inside the tube
            (from_axis(wrapped(x[0]), wrapped(x[1])) < 0.5 * (1 + outer) ? within : beside) +=
                view[sph::mass](i) / view[sph::density](i);
        }
        rise.found += within / pi - beside / outside;
        ++times;
    });
    rise.found /= times;
    return rise;
}

inline std::vector<Measured> measure(int across) {
    const Rise seen = rise(across, 60);
    return {{"rise with a contact angle of 60, degrees", "5 % at 20", seen.found, seen.exact}};
}

} // namespace validation::capillary_tube
