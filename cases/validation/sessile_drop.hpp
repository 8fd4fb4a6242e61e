// A drop on a wall that it meets at a given angle, and a drop that touches nothing.
//
// Reference: Young's angle, from a drop that starts at another; Laplace's pressure sigma/R, and rest.
// Geometry: rho = sigma = 1, viscosity 0.1 (on the wall: half a disc of R = 1, in a box of 6 by 3) and 0.01 (free: a
// disc of R = 1, in a square of 4), both liquids of the same density and viscosity.
// Scheme: presets::TwoLiquids; sound is 20.
// Measure: the angle of the part of a disc that has the drop's area and centre of mass, the mean from t = 9 to 10; the
// pressure within R/2 less that beyond 1.5 R, the mean speed squared of the drop, its root, from t = 4 to 6.
#pragma once

#include "case.hpp"

#include <imbibe/core/error.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/presets/two_liquids.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace validation::sessile_drop {

namespace sph = imbibe;
using Preset = sph::presets::TwoLiquids;
using Scene = Preset::Scene<2, double>;
using Point = Eigen::Vector2d;

constexpr double pi = std::numbers::pi, sound = 20;

/// What drops differ in, besides their shape and size.
struct Kind {
    double viscosity = 0.1;  ///< of the drop
    double angle = 0.5 * pi; ///< with the walls, rad
    double lighter = 1;      ///< times as light is the other liquid, of the same rho c^2 and kinematic viscosity
    double cfl = 0.4;        ///< the CFL number
};

/// A drop of water where `in_drop(x)`, in a box that is periodic along x and full of oil.
inline Scene drop(const Point& size, double spacing, const Kind& kind, const auto& in_drop) {
    Scene scene({.support_radius = 3 * spacing, .cfl = kind.cfl, .periodic_length = {size[0], 0}, .threads = 1});
    const Preset::Interface interface { .surface_tension = 1, .contact_angle = kind.angle };
    Preset::Water water{{.density = 1, .sound_speed = sound, .viscosity = kind.viscosity}};
    Preset::Oil oil{{.density = 1 / kind.lighter,
                     .sound_speed = sound * std::sqrt(kind.lighter),
                     .viscosity = kind.viscosity / kind.lighter}};
    Preset::set_coefficients(water, interface, spacing);
    Preset::set_coefficients(oil, interface, spacing);
    std::vector<Point> inside, outside;
    for (const auto& x : sph::fill(sph::Box<2>({0, 0}, size), spacing))
        (in_drop(x) ? inside : outside).push_back(x);
    scene.add(water, inside, spacing);
    scene.add(oil, outside, spacing);
    scene.add(Preset::Vessel{{.density = 1, .viscosity = kind.viscosity}},
              sph::tank(sph::Box<2>({0, 0}, size), spacing, 4, sph::Sides::x), spacing);
    Preset::set_coefficients(scene, interface);
    return scene;
}

/// The mean pressure of the particles of a view from one distance to another of a point.
inline double mean_pressure(const auto& view, const Point& centre, double from, double to) {
    double sum = 0;
    int count = 0;
    for (int i = 0; i < view.size(); ++i) {
        const double r = std::hypot(view[sph::position](i, 0) - centre[0], view[sph::position](i, 1) - centre[1]);
        if (r >= from && r < to)
            sum += view[sph::pressure](i), ++count;
    }
    return sum / count;
}

/// The angle at the rim, rad, of the part of a disc above a line, from its area and the height of its centre of mass.
inline double angle_of(double area, double height) {
    double least = 0.02, most = pi - 0.02;
    for (int halving = 0; halving < 50; ++halving) {
        const double angle = 0.5 * (least + most);
        const double radius = std::sqrt(area / (angle - std::sin(angle) * std::cos(angle)));
        const double centre = 2.0 / 3 * sph::power<3>(radius * std::sin(angle)) / area - radius * std::cos(angle);
        (centre < height ? least : most) = angle;
    }
    return least;
}

/// The angle, degrees, that half a disc with so many particles over its radius comes to.
inline double contact_angle(double across, double degrees) {
    const double spacing = 1 / across;
    Scene scene = drop({6, 3}, spacing, {.angle = degrees * pi / 180},
                       [](const Point& x) { return std::hypot(x[0] - 3, x[1]) < 1; });
    double sum = 0;
    int times = 0;
    scene.run_until(10, [&](const Scene& s) {
        if (s.time() < 9)
            return;
        const auto water = s.get<Preset::Water>();
        const double area = sph::sq(spacing) * static_cast<double>(water.size());
        sum += angle_of(area, water[sph::position].col(1).mean()) * 180 / pi;
        ++times;
    });
    return sum / times;
}

/// What a drop does that touches nothing.
struct Free {
    double pressure = 0; ///< over sigma/R
    double speed = 0;    ///< root mean square, sqrt(sigma/(rho R))
};
/// With so many particles over its radius.
inline Free free_drop(double across) {
    const double spacing = 1 / across;
    Scene scene =
        drop({4, 4}, spacing, {.viscosity = 0.01}, [](const Point& x) { return std::hypot(x[0] - 2, x[1] - 2) < 1; });
    Free seen;
    int times = 0;
    scene.run_until(6, [&](const Scene& s) {
        if (s.time() < 4)
            return;
        const auto water = s.get<Preset::Water>();
        seen.pressure += mean_pressure(water, {2, 2}, 0, 0.5) - mean_pressure(s.get<Preset::Oil>(), {2, 2}, 1.5, 9);
        seen.speed += water[sph::velocity].rowwise().squaredNorm().mean();
        ++times;
    });
    const double radius = spacing * std::sqrt(static_cast<double>(scene.get<Preset::Water>().size()) / pi);
    seen.pressure *= radius / times;
    seen.speed = std::sqrt(seen.speed / times);
    return seen;
}

inline std::vector<Measured> measure(int across) {
    const Free still = free_drop(across);
    std::vector<Measured> found{{"pressure in a free drop over sigma/R", "5 % at 16", still.pressure, 1},
                                {"1 + speed in a free drop", "2 %", 1 + still.speed, 1}};
    for (const double angle : {30.0, 60.0, 90.0, 120.0, 150.0})
        found.push_back(
            {sph::text("contact angle ", angle, ", degrees"), "5 degrees", contact_angle(across, angle), angle});
    return found;
}

} // namespace validation::sessile_drop
