// A drop of one liquid on a wall that it meets at a given angle, with nothing around it, from a flatter and from a
// steeper start.
//
// Reference: Young's angle.
// Geometry: a part of a disc with the area of half a disc of R = 1, cut from a lattice at an angle 30 degrees above or
// below (from 20 to 160); rho = sigma = 1, viscosity 0.1; the wall is 7 spacings thick.
// Scheme: presets::WettingLiquid, settled; sound is 20.
// Measure: the angle at the wall of the circle through the outermost particles (density below 0.93 rho, 5 spacings
// above the wall), 0.94 spacings outside them, as in a free disc that holds its area; the mean from t = 10 to 12.
#pragma once

#include "case.hpp"

#include <imbibe/core/error.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/presets/wetting_liquid.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace validation::wetting_drop {

namespace sph = imbibe;
using Preset = sph::presets::WettingLiquid;
using Scene = Preset::Scene<2, double>;
using Point = Eigen::Vector2d;

constexpr double pi = std::numbers::pi;

/// A drop on a wall, settled. @param across particles over the radius of half a disc of its area @param begun the angle
/// it begins with, degrees
inline Scene drop(double across, double degrees, double begun) {
    const double spacing = 1 / across, angle = begun * pi / 180;
    const double radius = std::sqrt(0.5 * pi / (angle - std::sin(angle) * std::cos(angle)));
    const Point centre(0, -radius * std::cos(angle));
    Scene scene({.support_radius = 5 * spacing, .threads = 1});
    std::vector<Point> points;
    for (const auto& x : sph::fill(sph::Box<2>({-4, 0}, {4, 3}), spacing))
        if ((x - centre).norm() < radius)
            points.push_back(x);
    scene.add(Preset::Water{{.density = 1, .sound_speed = 20, .viscosity = 0.1}}, points, spacing);
    scene.add(Preset::Vessel{{.density = 1, .viscosity = 0.1}},
              sph::fill(sph::Box<2>({-4, -7 * spacing}, {4, 0}), spacing), spacing);
    Preset::set_coefficients(scene, {.surface_tension = 1, .contact_angle = degrees * pi / 180});
    sph::settle_surface<Preset::Water>(scene);
    return scene;
}

/// The angle at the wall, degrees, of the circle through the outermost particles.
inline double angle_of(const Scene& scene) {
    const auto water = scene.get<Preset::Water>();
    const double spacing = water.material().spacing;
    Eigen::Matrix3d sums = Eigen::Matrix3d::Zero(); // of (2x, 2y, 1) . (centre, R^2 - centre^2) = x^2 + y^2
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (int i = 0; i < water.size(); ++i) {
        const Point x = water[sph::position].row(i).transpose();
        if (water[sph::density](i) < 0.93 && x[1] > 5 * spacing) {
            const Eigen::Vector3d row(2 * x[0], 2 * x[1], 1);
            sums += row * row.transpose();
            right += x.squaredNorm() * row;
        }
    }
    const Eigen::Vector3d fit = sums.ldlt().solve(right);
    const double radius = std::sqrt(fit[2] + sph::sq(fit[0]) + sph::sq(fit[1])) + 0.94 * spacing;
    return std::acos(std::clamp(-fit[1] / radius, -1.0, 1.0)) * 180 / pi;
}

/// The angle, degrees, that a drop comes to.
inline double contact_angle(double across, double degrees, double begun) {
    Scene scene = drop(across, degrees, begun);
    const double begin = scene.time();
    double sum = 0;
    int times = 0;
    scene.run_until(begin + 12, [&](const Scene& s) {
        if (s.time() < begin + 10)
            return;
        sum += angle_of(s);
        ++times;
    });
    return sum / times;
}

inline std::vector<Measured> measure(int across) {
    std::vector<Measured> found;
    for (const double degrees : {30.0, 60.0, 90.0, 120.0, 150.0})
        for (const double more : {-30.0, 30.0})
            found.push_back({sph::text("contact angle ", degrees, more < 0 ? ", advancing" : ", receding", ", degrees"),
                             "5 degrees at 24", contact_angle(across, degrees, std::clamp(degrees - more, 20.0, 160.0)),
                             degrees});
    return found;
}

} // namespace validation::wetting_drop
