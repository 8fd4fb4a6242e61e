// A heavy liquid on a light one: how fast a small wave of their interface grows, at a given background pressure.
//
// Reference: linear theory, s = sqrt(At g k + (nu k^2)^2) - nu k^2 with At = (rho - rho_o)/(rho + rho_o) (Duff,
// Harlow and Hirt 1962, an approximation for equal kinematic viscosities).
// Geometry: wave length = g = 1, a height of 1 of each liquid, rho = 1.8 on 1, viscosity rho/420, an amplitude of 0.01
// and the velocity of the growing mode.
// Scheme: presets::TwoLiquids on a square lattice that is shifted as the wave moves it; rho c^2 = 90.
// Measure: the rate of growth of sum_b V_b v_b cos(k x_b) from t = 0.3 to 1.2.
#pragma once

#include "capillary_wave.hpp"
#include "case.hpp"

#include <imbibe/core/error.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/presets/two_liquids.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace validation::rayleigh_taylor {

namespace sph = imbibe;
using Preset = sph::presets::TwoLiquids;

constexpr double k = 2 * std::numbers::pi, heavier = 1.8, kinematic = 1.0 / 420, amplitude = 0.01, stiffness = 90;

/// The rate of linear theory.
inline double exact() {
    const double damping = kinematic * k * k;
    return std::sqrt((heavier - 1) / (heavier + 1) * k + damping * damping) - damping;
}

/// The rate of growth with so many particles in the wave's length, under so many rho g lambda of the heavier liquid.
inline double growth(double across, double background) {
    const double spacing = 1 / across;
    Preset::Scene<2, double> scene(
        {.gravity = {0, -1}, .support_radius = 3 * spacing, .cfl = 0.4, .periodic_length = {1, 0}, .threads = 1});
    Preset::Water heavy{
        {.density = heavier, .sound_speed = std::sqrt(stiffness / heavier), .viscosity = heavier * kinematic}};
    Preset::Oil light{{.density = 1, .sound_speed = std::sqrt(stiffness), .viscosity = kinematic}};
    heavy.set(sph::UnderPressureParameters{.background = background * heavier});
    light.set(sph::UnderPressureParameters{.background = background * heavier});
    const auto [below, above] = capillary_wave::layers(spacing, amplitude);
    scene.add(heavy, above, spacing);
    scene.add(light, below, spacing);
    scene.add(Preset::Vessel{{.density = heavier, .viscosity = heavier * kinematic}},
              sph::tank(sph::Box<2>({0, -1}, {1, 1}), spacing, 4, sph::Sides::x), spacing);
    const auto start = [&](const auto& view, double density, double weight_above) {
        for (int i = 0; i < view.size(); ++i) {
            const double x = view[sph::position](i, 0), y = view[sph::position](i, 1);
            const double pressure = weight_above + density * ((y > 0 ? 1 : 0) - y);
            view[sph::density](i) = density * (1 + pressure / stiffness);
            view[sph::mass](i) = view[sph::density](i) * sph::sq(spacing);
            const double speed = amplitude * exact() * std::exp(-k * std::abs(y));
            view[sph::velocity](i, 0) = (y < 0 ? -speed : speed) * std::sin(k * x);
            view[sph::velocity](i, 1) = speed * std::cos(k * x);
        }
    };
    start(scene.get<Preset::Water>(), heavier, 0);
    start(scene.get<Preset::Oil>(), 1, heavier);
    double first = 0, from = 0;
    const auto mode = [&] {
        double sum = 0;
        const auto add = [&](const auto& view) {
            sum += ((view[sph::mass].array() / view[sph::density].array()) * view[sph::velocity].col(1).array() *
                    (k * view[sph::position].col(0).array()).cos())
                       .sum();
        };
        add(scene.get<Preset::Water>());
        add(scene.get<Preset::Oil>());
        return sum;
    };
    scene.run_until(0.3);
    first = mode(), from = scene.time();
    scene.run_until(1.2);
    return std::log(mode() / first) / (scene.time() - from);
}

inline std::vector<Measured> measure(int across) {
    std::vector<Measured> found;
    for (const double background : {0.0, 1.0, 10.0})
        found.push_back(
            {sph::text("rate under ", background, " rho g lambda"), "5 % at 64", growth(across, background), exact()});
    return found;
}

} // namespace validation::rayleigh_taylor
