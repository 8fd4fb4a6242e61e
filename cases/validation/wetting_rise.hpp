// One liquid that rises between two plates against its weight, with nothing above it.
//
// Reference: Jurin; between plates at a distance d, beside a gap D, the levels differ by
// 2 sigma cos theta/(rho g) (1/d - 1/D).
// Geometry: d = 1, D = 2, plates of 7 spacings that end 0.6 above the floor, in a periodic row; water up to 2.5; rho =
// sigma = 1, g = 0.5, viscosity 0.05; the levels begin with half of the difference, or one and a half times it.
// Scheme: presets::WettingLiquid, settled; sound is 20.
// Measure: the mean level of water between the plates, by its volume, less that in the other gap, from t = 22.5 to 30.
#pragma once

#include "case.hpp"

#include <imbibe/core/error.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/presets/wetting_liquid.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace validation::wetting_rise {

namespace sph = imbibe;
using Preset = sph::presets::WettingLiquid;
using Point = Eigen::Vector2d;

constexpr double wide = 2, level = 2.5, height = 5.5, lowest = 0.6, gravity = 0.5;

/// By how much the levels differ in the end.
/// @param across particles between the plates @param degrees the contact angle @param begun by how much they differ at
/// first
inline double rise(double across, double degrees, double begun) {
    constexpr double end = 30;
    const double spacing = 1 / across, thick = 7 * spacing, width = 1 + wide + 2 * thick;
    Preset::Scene<2, double> scene(
        {.gravity = {0, -gravity}, .support_radius = 5 * spacing, .periodic_length = {width, 0}, .threads = 1});
    // From the left: a plate, the narrow gap, a plate, the wide gap.
    const auto in_narrow = [&](double x) { return x > thick && x < thick + 1; };
    const auto in_plate = [&](const Point& x) { return x[1] > lowest && x[0] < 1 + 2 * thick && !in_narrow(x[0]); };
    std::vector<Point> water, plates;
    for (const auto& x : sph::fill(sph::Box<2>({0, 0}, {width, height}), spacing))
        if (in_plate(x))
            plates.push_back(x);
        else if (x[1] < level + begun * (in_narrow(x[0]) ? 2.0 : -1.0) / 3)
            water.push_back(x);
    const auto tank = sph::tank(sph::Box<2>({0, 0}, {width, height}), spacing, 7, sph::Sides::x);
    plates.insert(plates.end(), tank.begin(), tank.end());
    scene.add(Preset::Water{{.density = 1, .sound_speed = 20, .viscosity = 0.05}}, water, spacing);
    scene.add(Preset::Vessel{{.density = 1, .viscosity = 0.05}}, plates, spacing);
    Preset::set_coefficients(scene, {.surface_tension = 1, .contact_angle = degrees * std::numbers::pi / 180});
    sph::settle_surface<Preset::Water>(scene);
    const double begin = scene.time();
    double sum = 0;
    int times = 0;
    scene.run_until(begin + end, [&](const auto& s) {
        if (s.time() < begin + 0.75 * end)
            return;
        const auto view = s.template get<Preset::Water>();
        double narrow = 0, other = 0;
        for (int i = 0; i < view.size(); ++i) {
            const double x = view[sph::position](i, 0) - width * std::floor(view[sph::position](i, 0) / width);
            if (view[sph::position](i, 1) > lowest + 3 * spacing) // below and just inside the gaps it is the same
                (in_narrow(x) ? narrow : other) += view[sph::mass](i);
        }
        sum += narrow - other / wide;
        ++times;
    });
    return sum / times;
}

/// Jurin's.
inline double exact(double degrees) {
    return 2 * std::cos(degrees * std::numbers::pi / 180) / gravity * (1 - 1 / wide);
}

inline std::vector<Measured> measure(int across) {
    std::vector<Measured> found;
    for (const double degrees : {30.0, 60.0, 120.0})
        for (const double begun : {0.5, 1.5})
            found.push_back({sph::text("rise with a contact angle of ", degrees, " degrees, from ",
                                       begun < 1 ? "half" : "one and a half"),
                             "5 % at 20", rise(across, degrees, begun * exact(degrees)), exact(degrees)});
    return found;
}

} // namespace validation::wetting_rise
