// Water that rises between two plates, against its weight, and pushes out what was there.
//
// Reference: Jurin; between plates at a distance d, beside a gap D, the levels differ by
// 2 sigma cos theta/((rho - rho_o) g) (1/d - 1/D).
// Geometry: d = 1, D = 2, plates of 4 spacings that end 0.6 from floor and ceiling, in a periodic row; water up to 1.5;
// rho = sigma = 1, rho_o = 0.5, g = 1, viscosity 0.03 of both; the levels begin with half of the difference.
// Scheme: presets::TwoLiquids, from a lattice jittered by a fifth of a spacing; sound is 14.
// Measure: the mean level of water between the plates, by its volume, less that in the other gap, from t = 7.5 to 10.
#pragma once

#include "case.hpp"

#include <imbibe/core/error.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/presets/two_liquids.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace validation::capillary_rise {

namespace sph = imbibe;
using Preset = sph::presets::TwoLiquids;
using Point = Eigen::Vector2d;

constexpr double wide = 2, level = 1.5, height = 4, lowest = 0.6, lighter = 0.5, gravity = 1;

/// By how much the levels differ in the end.
/// @param across particles between the plates @param degrees the contact angle @param begun by how much they differ at
/// first
inline double rise(double across, double degrees, double begun) {
    constexpr double end = 10;
    const double spacing = 1 / across, thick = 4 * spacing, width = 1 + wide + 2 * thick;
    Preset::Scene<2, double> scene({.gravity = {0, -gravity},
                                    .support_radius = 3 * spacing,
                                    .cfl = 0.4,
                                    .periodic_length = {width, 0},
                                    .threads = 1});
    const Preset::Interface interface { .surface_tension = 1, .contact_angle = degrees * std::numbers::pi / 180 };
    Preset::Water water{{.density = 1, .sound_speed = 14, .viscosity = 0.03}};
    Preset::Oil oil{{.density = lighter, .sound_speed = 14 / std::sqrt(lighter), .viscosity = 0.03}};
    Preset::set_coefficients(water, interface, spacing);
    Preset::set_coefficients(oil, interface, spacing);
    // From the left: a plate, the narrow gap, a plate, the wide gap.
    const auto in_narrow = [&](double x) { return x > thick && x < thick + 1; };
    const auto in_plate = [&](const Point& x) {
        return x[1] > lowest && x[1] < height - lowest && x[0] < 1 + 2 * thick && !in_narrow(x[0]);
    };
    std::vector<Point> below, above, plates;
    for (const auto& x : sph::fill(sph::Box<2>({0, 0}, {width, height}), spacing))
        (in_plate(x) ? plates : x[1] < level + begun * (in_narrow(x[0]) ? 2.0 : -1.0) / 3 ? below : above).push_back(x);
    const auto tank = sph::tank(sph::Box<2>({0, 0}, {width, height}), spacing, 4, sph::Sides::x);
    plates.insert(plates.end(), tank.begin(), tank.end());
    scene.add(water, sph::jitter<2>(below, 0.2 * spacing, 1), spacing);
    scene.add(oil, sph::jitter<2>(above, 0.2 * spacing, 2), spacing);
    scene.add(Preset::Vessel{{.density = 1, .viscosity = 0.03}}, plates, spacing);
    Preset::set_coefficients(scene, interface);
    const auto heavy = scene.get<Preset::Water>();
    for (int i = 0; i < heavy.size(); ++i) {
        const double weight = gravity * (lighter * (height - level) + level - heavy[sph::position](i, 1));
        heavy[sph::density](i) += weight / sph::sq(14);
        heavy[sph::mass](i) *= heavy[sph::density](i);
    }
    const auto light = scene.get<Preset::Oil>();
    for (int i = 0; i < light.size(); ++i) {
        const double share = 1 + gravity * (height - light[sph::position](i, 1)) / sph::sq(14 / std::sqrt(lighter));
        light[sph::density](i) *= share;
        light[sph::mass](i) *= share;
    }
    double sum = 0;
    int times = 0;
    scene.run_until(end, [&](const auto& s) {
        if (s.time() < 0.75 * end)
            return;
        const auto view = s.template get<Preset::Water>();
        double narrow = 0, other = 0;
        for (int i = 0; i < view.size(); ++i) {
            const double x = view[sph::position](i, 0) - width * std::floor(view[sph::position](i, 0) / width);
            if (view[sph::position](i, 1) < lowest + 3 * spacing)
                continue; // below and just inside the gaps
            (in_narrow(x) ? narrow : other) += view[sph::mass](i) / view[sph::density](i);
        }
        sum += narrow - other / wide;
        ++times;
    });
    return sum / times;
}

/// Jurin's.
inline double exact(double degrees) {
    return 2 * std::cos(degrees * std::numbers::pi / 180) / ((1 - lighter) * gravity) * (1 - 1 / wide);
}

inline std::vector<Measured> measure(int across) {
    std::vector<Measured> found;
    for (const double degrees : {60.0, 120.0})
        found.push_back({sph::text("rise with a contact angle of ", degrees, ", degrees"), "5 % at 20",
                         rise(across, degrees, exact(degrees) / 2), exact(degrees)});
    return found;
}

} // namespace validation::capillary_rise
