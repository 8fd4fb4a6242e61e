// A bubble that rises in a liquid of ten times its density and viscosity: first test of Hysing and others (2009).
//
// Reference: Hysing, Turek, Kuzmin, Parolini, Burman, Ganesan and Tobiska (2009).
// Geometry: a disc of R = 0.25 in a box of 1 by 2 with its centre 0.5 above the floor; rho = 1000 and 100, viscosity 10
// and 1, gravity 0.98, tension 24.5; floor and ceiling are no-slip, the sides those of a periodic row of bubbles.
// Scheme: presets::TwoLiquids; sound of the liquid is 14, the pressure starts as that of a liquid at rest.
// Measure: at t = 3 the height of the bubble's centre of mass; its greatest speed, over times of 0.3, within which the
// sound of the start goes up and down once; the least circularity 2 sqrt(pi A)/P, with the length P = sum V |G|/sigma.
#pragma once

#include "case.hpp"

#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/presets/two_liquids.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace validation::rising_bubble {

namespace sph = imbibe;
using Preset = sph::presets::TwoLiquids;

/// What the bubble does.
struct Rise {
    double height = 0;          ///< at t = 3
    double speed = 0, when = 0; ///< the greatest
    double circularity = 1;     ///< the least
};

inline Rise rise(double across) {
    constexpr double gravity = 0.98, tension = 24.5, radius = 0.25, sound = 14;
    const double spacing = 1 / across;
    Preset::Scene<2, double> scene(
        {.gravity = {0, -gravity}, .support_radius = 3 * spacing, .cfl = 0.4, .periodic_length = {1, 0}, .threads = 1});
    const Preset::Interface interface { .surface_tension = tension };
    Preset::Water liquid{{.density = 1000, .sound_speed = sound, .viscosity = 10}};
    Preset::Oil bubble{{.density = 100, .sound_speed = sound * std::sqrt(10.0), .viscosity = 1}};
    Preset::set_coefficients(liquid, interface, spacing);
    Preset::set_coefficients(bubble, interface, spacing);
    const auto is_inside = [](const Eigen::Vector2d& x) { return std::hypot(x[0] - 0.5, x[1] - 0.5) < radius; };
    std::vector<Eigen::Vector2d> inside, outside;
    for (const auto& x : sph::fill(sph::Box<2>({0, 0}, {1, 2}), spacing))
        (is_inside(x) ? inside : outside).push_back(x);
    scene.add(liquid, outside, spacing);
    scene.add(bubble, inside, spacing);
    scene.add(Preset::Vessel{{.density = 1000, .viscosity = 10}},
              sph::tank(sph::Box<2>({0, 0}, {1, 2}), spacing, 4, sph::Sides::x), spacing);
    Preset::set_coefficients(scene, interface);
    const auto start = [&](const auto& view, const auto& material, double more) { // its masses with the density
        for (int i = 0; i < view.size(); ++i) {
            const double pressure = 1000 * gravity * (2 - view[sph::position](i, 1)) + more;
            const double share = 1 + pressure / (material.density * sph::sq(material.sound_speed));
            view[sph::density](i) *= share;
            view[sph::mass](i) *= share;
        }
    };
    start(scene.get<Preset::Water>(), liquid, 0);
    start(scene.get<Preset::Oil>(), bubble, tension / radius);

    Rise seen;
    std::vector<double> times, heights;
    std::size_t back = 0;
    scene.run_until(3, [&](const auto& s) {
        const auto heavy = s.template get<Preset::Water>();
        const auto light = s.template get<Preset::Oil>();
        times.push_back(s.time());
        heights.push_back(light[sph::position].col(1).mean());
        while (back + 1 < times.size() && times[back + 1] <= s.time() - 0.3)
            ++back;
        if (s.time() < 0.3)
            return;
        const double speed = (heights.back() - heights[back]) / (s.time() - times[back]);
        if (speed > seen.speed)
            seen.speed = speed, seen.when = 0.5 * (s.time() + times[back]);
        const auto length = [](const auto& view) {
            double sum = 0;
            for (int i = 0; i < view.size(); ++i)
                sum += view[sph::mass](i) / view[sph::density](i) * view[sph::interface_gradient].row(i).norm();
            return sum / tension;
        };
        const double area = sph::sq(spacing) * static_cast<double>(light.size());
        seen.circularity =
            std::min(seen.circularity, 2 * std::sqrt(std::numbers::pi * area) / (length(heavy) + length(light)));
    });
    seen.height = heights.back();
    return seen;
}

inline std::vector<Measured> measure(int across) {
    const Rise found = rise(across);
    return {{"greatest speed of rise", "1.5 % at 64", found.speed, 0.2417},
            {"when it is reached", "none given", found.when, 0.92},
            {"height at t = 3", "0.5 % at 64", found.height, 1.081},
            {"least circularity", "1 % at 64", found.circularity, 0.901}};
}

} // namespace validation::rising_bubble
