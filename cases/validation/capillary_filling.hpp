// Water that is drawn along a slit between two plates and pushes an oil of the same viscosity out of it.
//
// Reference: Washburn (1921) for two liquids, v = d^2 p/(12 eta (L + 0.849 d)), with the loss at both ends as that of a
// slit in a thin wall, 32 eta v/(pi d) (Roscoe 1949), and p = 2 sigma (cos theta_d/d - cos theta_D/D) with the
// angles of the interfaces in the slit and in the reservoirs; he takes those at rest, theta. By Cox (1986) that of an
// advancing line is larger, that of a receding one smaller: with a slip length s of the line the integral of dx/f(x)
// from theta to theta_d is eta v/sigma ln(d/(2 s)), from theta to theta_D - eta v/(3 sigma) ln(D/(2 s)), where for two
// liquids of the same viscosity
// f(x) = 2 pi^2 sin x/((x^2 - sin^2 x)(pi - x + sin x cos x) + ((pi - x)^2 - sin^2 x)(x - sin x cos x)).
// Here s is 4.5 spacings, chosen for the speeds at 30 degrees.
// Geometry: a slit of d = 1 and L = 4 between reservoirs of D = 3 that meet through the periodic side; rho = sigma = 1,
// viscosity 0.3 of both. Water begins at a quarter of the slit.
// Scheme: presets::TwoLiquids from a lattice jittered by a fifth of a spacing; sound is 20.
// Measure: the mean speed of the front, by the volume of water in the slit, from a third of it to three quarters.
#pragma once

#include "case.hpp"

#include <imbibe/core/error.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/presets/two_liquids.hpp>

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <vector>

namespace validation::capillary_filling {

namespace sph = imbibe;
using Preset = sph::presets::TwoLiquids;

constexpr double pi = std::numbers::pi;
constexpr double wide = 3, reservoir = 2, length = 4, viscosity = 0.3, slip = 4.5; ///< slip in spacings

/// Cox's angle of a line that advances at a speed, rad. @param logarithm ln(d/(2 s)), d the width between its walls
inline double moving_angle(double angle, double speed, double logarithm) {
    const int steps = 1000;
    for (int i = 0; i < steps; ++i) {
        const double other = pi - angle, sine = std::sin(angle), product = sine * std::cos(angle);
        angle += viscosity * speed * logarithm / steps * 2 * sph::sq(pi) * sine /
                 ((sph::sq(angle) - sph::sq(sine)) * (other + product) +
                  (sph::sq(other) - sph::sq(sine)) * (angle - product));
    }
    return angle;
}

/// The speed of the reference: Washburn's; with a slip length above 0, in widths of the slit, with Cox's angles.
inline double exact(double degrees, double slip_length = 0) {
    const double angle = degrees * pi / 180;
    const auto logarithm = [&](double width) { return slip_length > 0 ? std::log(width / (2 * slip_length)) : 0; };
    double speed = 0;
    for (int i = 0; i < 50; ++i) { // every change is a fraction of the one before
        const double front = moving_angle(angle, speed, logarithm(1)),
                     behind = moving_angle(angle, -speed / wide, logarithm(wide));
        const double pressure = 2 * (std::cos(front) - std::cos(behind) / wide);
        speed = pressure / (12 * viscosity * (length + 32 / (12 * pi)));
    }
    return speed;
}

/// The mean speed of the front, with so many particles across the slit; 0 if it stops.
inline double speed(double across, double degrees) {
    const double spacing = 1 / across, whole = 2 * reservoir + length;
    Preset::Scene<2, double> scene(
        {.support_radius = 3 * spacing, .cfl = 0.4, .periodic_length = {whole, 0}, .threads = 1});
    const Preset::Interface interface { .surface_tension = 1, .contact_angle = degrees * pi / 180 };
    Preset::Water water{{.density = 1, .sound_speed = 20, .viscosity = viscosity}};
    Preset::Oil oil{{.density = 1, .sound_speed = 20, .viscosity = viscosity}};
    Preset::set_coefficients(water, interface, spacing);
    Preset::set_coefficients(oil, interface, spacing);
    const sph::Box<2> box({0, -1}, {whole, 2});
    const auto along_slit = [](double x) { return x > reservoir && x < reservoir + length; };
    std::vector<Eigen::Vector2d> left, right, plates = sph::tank(box, spacing, 4, sph::Sides::x);
    for (const auto& x : sph::fill(box, spacing))
        (along_slit(x[0]) && (x[1] < 0 || x[1] > 1) ? plates
         : x[0] < reservoir + 0.25 * length         ? left
                                                    : right)
            .push_back(x);
    scene.add(water, sph::jitter<2>(left, 0.2 * spacing, 1), spacing);
    scene.add(oil, sph::jitter<2>(right, 0.2 * spacing, 2), spacing);
    scene.add(Preset::Vessel{{.density = 1, .viscosity = viscosity}}, plates, spacing);
    Preset::set_coefficients(scene, interface);
    double since = -1, until = -1, begin = 0, end = 0;
    while (until < 0 && scene.time() < 4 * length / exact(degrees)) {
        scene.step();
        const auto view = scene.get<Preset::Water>();
        double front = 0; // the slit is 1 wide
        for (int i = 0; i < view.size(); ++i)
            if (along_slit(view[sph::position](i, 0) - whole * std::floor(view[sph::position](i, 0) / whole)))
                front += view[sph::mass](i) / view[sph::density](i);
        if (since < 0 && front > length / 3)
            since = scene.time(), begin = front;
        if (front > 0.75 * length)
            until = scene.time(), end = front;
    }
    return until < 0 ? 0 : (end - begin) / (until - since);
}

/// A speed at each of these angles, degrees, beside both forms of the reference.
inline std::vector<Measured> measured(double across, std::initializer_list<double> angles, const auto& speed_at,
                                      const auto& exact_at, double slip_spacings) {
    std::vector<Measured> found;
    for (const double degrees : angles) {
        const double computed = speed_at(across, degrees);
        found.push_back({sph::text("speed with a contact angle of ", degrees, ", degrees"), "10 % at 20", computed,
                         exact_at(degrees, 0)});
        found.push_back({sph::text("the same, beside Washburn with Cox's angles, ", degrees, ", degrees"), "10 % at 20",
                         computed, exact_at(degrees, slip_spacings / across)});
    }
    return found;
}

inline std::vector<Measured> measure(int across) {
    return measured(across, {30.0, 60.0}, speed, exact, slip);
}

} // namespace validation::capillary_filling
