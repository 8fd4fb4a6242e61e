// A plate that is held at one end and started with the velocity of its first mode.
//
// Reference: plane elasticity with a rigid root, computed by finite elements: a period of 0.2552 s.
// Geometry: Gray, Monaghan and Swift (2001): 0.2 x 0.02 m, 1000 kg/m^3, 2e6 Pa, nu = 0.3975; particles that are held
// beyond x = 0, more columns than a free one can see. V_f = 0.01: the end goes 0.02 m to either side.
// Scheme: St. Venant-Kirchhoff, total Lagrangian, Wendland C2 of 1.5 spacings, no damping.
// Measure: the mean period, and how much the greatest deflection of the last period has lost on that of the first.
#pragma once

#include "solid.hpp"

namespace validation::oscillating_plate {

constexpr double length = 0.2, thickness = 0.02;

/// The first mode of a cantilever, 1 at x = L (Landau and Lifshitz); nothing in the root.
inline double first_mode(double x) {
    const double kL = 1.8751040687;
    const auto f = [&](double z) {
        return (std::cos(kL) + std::cosh(kL)) * (std::cosh(z) - std::cos(z)) +
               (std::sin(kL) - std::sinh(kL)) * (std::sinh(z) - std::sin(z));
    };
    return x > 0 ? f(kL * x / length) / f(kL) : 0;
}

/// What a run shows.
struct Swings {
    std::vector<double> upward; ///< times at which the tip passes its rest position upwards, s
    std::vector<double> peaks;  ///< greatest deflection of the tip between them, m
};

inline Swings swing(int across, double support_ratio, double V_f, int periods) {
    const double spacing = thickness / across;
    PlateScene scene({.support_radius = support_ratio * spacing, .threads = 1});
    const ElasticPlate material = elastic<ElasticPlate>(2e6, 0.3975, 1000);
    const double root = std::ceil(2 * support_ratio) * spacing; // more than a particle of the plate can see
    const auto points = sph::fill(sph::Box<2>{{-root, -thickness / 2}, {length, thickness / 2}}, spacing);
    const auto plate = scene.add(material, points, spacing);
    scene.hold(plate, [](const auto& x) { return x[0] < 0; });
    auto view = scene[plate];
    for (int i = 0; i < view.size(); ++i)
        view[sph::velocity](i, 1) = V_f * material.sound_speed * first_mode(view[sph::position](i, 0));
    Swings seen{{0.0}, {}};
    double before = 0, greatest = 0;
    while (static_cast<int>(seen.peaks.size()) < periods && scene.time() < 0.5 * periods) {
        const double dt = scene.step(), now = end_displacement(view, across)[1];
        greatest = std::max(greatest, std::abs(now));
        if (before < 0 && now >= 0) {
            seen.upward.push_back(scene.time() - dt * now / (now - before));
            seen.peaks.push_back(greatest);
            greatest = 0;
        }
        before = now;
    }
    return seen;
}

inline std::vector<Measured> measure(int across) {
    const int periods = 10;
    const Swings seen = swing(across, 1.5, 0.01, periods);
    return {{"period, s", "2 % at 10", seen.upward.back() / periods, 0.2552},
            {"deflection in the tenth period, share of the first's", "2 %", seen.peaks.back() / seen.peaks.front(), 1}};
}

} // namespace validation::oscillating_plate
