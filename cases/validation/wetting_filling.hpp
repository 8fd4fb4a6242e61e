// One liquid that is drawn into a slit between two plates, with nothing before it.
//
// Reference: Washburn (1921), x dx/dt = d^2 p/(12 eta) with p = 2 sigma cos theta (1/d - 1/D) and x longer by 0.424 d,
// the loss at the mouth (Roscoe 1949); he takes angles at rest. By Cox (1986) and Voinov (1976) the integral of (x -
// sin x cos x)/(2 sin x) dx from theta to that of a line that advances with v is eta v/sigma ln(d/(2 s)), with a slip
// length s of the line, here a spacing, which is not fitted.
// Geometry: a slit of d = 1 from a reservoir of D = 4, 3 long, which is open to the other side; rho = sigma = 1,
// viscosity 0.3. The liquid begins at 1 in the slit.
// Scheme: presets::WettingLiquid, settled; sound is 20.
// Measure: 2 and 5 over the time in which the front comes from there to there, by the volume of liquid in the slit, the
// mean speed.
#pragma once

#include "capillary_filling.hpp"

#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/presets/wetting_liquid.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace validation::wetting_filling {

namespace sph = imbibe;
using Preset = sph::presets::WettingLiquid;

constexpr double pi = std::numbers::pi;
constexpr double wide = 4, reservoir = 3, length = 6, from = 2, to = 5, viscosity = 0.3;
constexpr double slip = 1; ///< spacings

/// The angle of a line that advances at a speed, rad. @param logarithm ln(d/(2 s))
inline double moving_angle(double angle, double speed, double logarithm) {
    const int steps = 1000;
    for (int i = 0; i < steps; ++i) {
        const double sine = std::sin(angle);
        angle += viscosity * speed * logarithm / steps * 2 * sine / (angle - sine * std::cos(angle));
    }
    return angle;
}

/// The mean speed of the front by the reference. @param slip_length in widths of the slit; 0: angles at rest
inline double exact(double degrees, double slip_length = 0) {
    const double angle = degrees * pi / 180, logarithm = slip_length > 0 ? std::log(0.5 / slip_length) : 0;
    double time = 0, speed = 0;
    const int steps = 300;
    for (int i = 0; i < steps; ++i) {
        const double x = from + (to - from) * (i + 0.5) / steps;
        for (int again = 0; again < 50; ++again) // every change is a fraction of the one before
            speed = 0.5 * speed + 0.5 * 2 * (std::cos(moving_angle(angle, speed, logarithm)) - std::cos(angle) / wide) /
                                      (12 * viscosity * (x + 16 / (12 * pi)));
        time += (to - from) / steps / speed;
    }
    return (to - from) / time;
}

/// The mean speed of the front, with so many particles across the slit; 0 if it stops.
inline double speed(double across, double degrees) {
    const double spacing = 1 / across, thick = 7 * spacing;
    Preset::Scene<2, double> scene({.support_radius = 5 * spacing, .threads = 1});
    std::vector<Eigen::Vector2d> water, plates;
    const auto in_slit = [](double x) { return x > 0 && x < length; };
    const auto off_axis = [](const auto& x) { return std::abs(x[1] - 0.5); };
    for (const auto& x :
         sph::fill(sph::Box<2>({-reservoir - 1, 0.5 - wide / 2 - thick}, {length, 0.5 + wide / 2 + thick}), spacing))
        if (off_axis(x) > (in_slit(x[0]) ? 0.5 : wide / 2))
            plates.push_back(x);
        else if (x[0] > -reservoir && x[0] < 1)
            water.push_back(x);
    scene.add(Preset::Water{{.density = 1, .sound_speed = 20, .viscosity = viscosity}}, water, spacing);
    scene.add(Preset::Vessel{{.density = 1, .viscosity = viscosity}}, plates, spacing);
    Preset::set_coefficients(scene, {.surface_tension = 1, .contact_angle = degrees * pi / 180});
    sph::settle_surface<Preset::Water>(scene);
    double since = -1, until = -1;
    const double limit = scene.time() + 4 * length / exact(degrees);
    while (until < 0 && scene.time() < limit) {
        scene.step();
        const auto view = scene.get<Preset::Water>();
        const double front = (view[sph::position].col(0).array() > 0).template cast<double>().sum() * sph::sq(spacing);
        if (since < 0 && front > from)
            since = scene.time();
        if (front > to)
            until = scene.time();
    }
    return until < 0 ? 0 : (to - from) / (until - since);
}

inline std::vector<Measured> measure(int across) {
    return capillary_filling::measured(across, {45.0, 60.0}, speed, exact, slip);
}

} // namespace validation::wetting_filling
