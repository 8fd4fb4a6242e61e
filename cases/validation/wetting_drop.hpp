// A drop of one liquid on a wall that it meets at a given angle, with nothing around it, from a flatter and from a
// steeper start.
//
// Reference: Young's angle.
// Geometry: a part of a disc with the area of half a disc of R = 1, cut from a lattice at an angle 30 degrees above or
// below, up to 160; in space a part of a ball with the volume of half a ball, in float. rho = sigma = 1, viscosity 0.1;
// the wall is 7 spacings thick.
// Scheme: presets::WettingLiquid, settled; sound is 20.
// Measure: the angle at the wall of the circle or ball through the outermost particles (density below 0.93 rho, above
// the wall by 5 spacings, in space 3), 0.94 spacings outside them, as in a free disc that holds its area; the mean from
// t = 10 to 12, in space from 5 to 6.
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
#include <type_traits>
#include <vector>

namespace validation::wetting_drop {

namespace sph = imbibe;
using Preset = sph::presets::WettingLiquid;
constexpr double pi = std::numbers::pi;

template <int dim>
using Real = std::conditional_t<dim == 2, double, float>;
template <int dim>
using Scene = Preset::Scene<dim, Real<dim>>;

/// A drop on a wall, settled. @param across particles over the radius of half a disc or half a ball as large @param
/// begun the angle it begins with, degrees
template <int dim>
Scene<dim> drop(double across, double degrees, double begun) {
    using Point = sph::Point<dim>;
    const double spacing = 1 / across, angle = begun * pi / 180, cosine = std::cos(angle);
    const double part =
        dim == 2 ? 2 / pi * (angle - std::sin(angle) * cosine) : 0.5 * sph::sq(1 - cosine) * (2 + cosine);
    const double radius = std::pow(part, -1.0 / dim), side = dim == 2 ? 4 : radius + 0.9;
    const auto box = [&](double low, double high) {
        Point lower = Point::Constant(-side), upper = Point::Constant(side);
        lower[dim - 1] = low;
        upper[dim - 1] = high;
        return sph::Box<dim>(lower, upper);
    };
    Point centre = Point::Zero();
    centre[dim - 1] = -radius * cosine;
    Scene<dim> scene({.support_radius = 5 * spacing, .threads = 1});
    std::vector<Point> points;
    for (const auto& x : sph::fill(box(0, 3), spacing))
        if ((x - centre).norm() < radius)
            points.push_back(x);
    scene.add(Preset::Water{{.density = 1, .sound_speed = 20, .viscosity = 0.1}}, points, spacing);
    scene.add(Preset::Vessel{{.density = 1, .viscosity = 0.1}}, sph::fill(box(-7 * spacing, 0), spacing), spacing);
    Preset::set_coefficients(scene, {.surface_tension = 1, .contact_angle = degrees * pi / 180});
    sph::settle_surface<Preset::Water>(scene);
    return scene;
}

/// The angle at the wall, degrees, of the circle or ball through the outermost particles.
template <int dim>
double angle_of(const Scene<dim>& scene) {
    const auto water = scene.template get<Preset::Water>();
    const double spacing = water.material().spacing;
    using Row = Eigen::Matrix<double, dim + 1, 1>; // (2x, 1) . (centre, R^2 - centre^2) = x^2
    Eigen::Matrix<double, dim + 1, dim + 1> sums = Eigen::Matrix<double, dim + 1, dim + 1>::Zero();
    Row right = Row::Zero();
    for (int i = 0; i < water.size(); ++i) {
        const sph::Point<dim> x = water[sph::position].row(i).transpose().template cast<double>();
        if (water[sph::density](i) < 0.93 && x[dim - 1] > (dim == 2 ? 5 : 3) * spacing) {
            Row row = Row::Ones();
            row.template head<dim>() = 2 * x;
            sums += row * row.transpose();
            right += x.squaredNorm() * row;
        }
    }
    const Row fit = sums.ldlt().solve(right);
    const double radius = std::sqrt(fit[dim] + fit.template head<dim>().squaredNorm()) + 0.94 * spacing;
    return std::acos(std::clamp(-fit[dim - 1] / radius, -1.0, 1.0)) * 180 / pi;
}

/// The angle, degrees, that a drop comes to.
template <int dim = 2>
double contact_angle(double across, double degrees, double begun) {
    auto scene = drop<dim>(across, degrees, begun);
    const double begin = scene.time(), end = dim == 2 ? 12 : 6;
    double sum = 0;
    int times = 0;
    scene.run_until(begin + end, [&](const Scene<dim>& s) {
        if (s.time() < begin + end * 5 / 6)
            return;
        sum += angle_of<dim>(s);
        ++times;
    });
    return sum / times;
}

template <int dim>
void add_angle(std::vector<Measured>& found, int across, double degrees, double more) {
    found.push_back({sph::text("contact angle ", degrees, more > 0 ? ", advancing" : ", receding", ", degrees"),
                     "5 degrees at 24", contact_angle<dim>(across, degrees, std::min(degrees + more, 160.0)), degrees});
}
inline std::vector<Measured> measure(int across) {
    std::vector<Measured> found;
    for (const double degrees : {30.0, 60.0, 90.0, 120.0, 150.0})
        for (const double more : {30.0, -30.0})
            if (degrees + more > 0)
                add_angle<2>(found, across, degrees, more);
    return found;
}
inline std::vector<Measured> measure_in_space(int across) {
    std::vector<Measured> found;
    for (const double degrees : {60.0, 90.0, 120.0})
        add_angle<3>(found, across, degrees, 30);
    add_angle<3>(found, across, 90, -30);
    return found;
}

} // namespace validation::wetting_drop
