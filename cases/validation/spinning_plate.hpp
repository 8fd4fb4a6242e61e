// A free plate that spins about its middle.
//
// Reference: nothing acts on it, so angular momentum and energy stay what they are.
// Geometry: 1 x 1 m, 1100 kg/m^3, 1.7e7 Pa, nu = 0.45, 50 rad/s, started as a rigid body: it stretches under its own
// spin and swings about the stretched shape.
// Scheme: St. Venant-Kirchhoff, total Lagrangian, Wendland C2 of 2 spacings, no damping.
// Measure: the greatest deviation of angular momentum, and of kinetic and elastic energy without that of the hourglass
// control, over ten turns of the rigid plate; the greatest radius early and late, before and after the second turn; by
// how much the von Mises stress is greater late than early, in rho omega^2 R^2 with R half the diagonal: its mean over
// plate and steps, the greatest of its means over the plate, and the greatest of all particles and steps.
#pragma once

#include "free_surface.hpp"
#include "solid.hpp"

#include <numbers>

namespace validation::spinning_plate {

/// The von Mises stress over the particles of a plate, Pa.
struct Mises {
    double mean, greatest;
};

inline Mises von_mises(const auto& plate) {
    const auto F = plate[sph::deformation_gradient];
    const double G = plate.material().shear_modulus, lambda = sph::detail::lame_lambda(plate.material());
    Mises found{0, 0};
    for (int i = 0; i < plate.size(); ++i) {
        const sph::Tensor<double, 3> f{{F(i, 0), F(i, 1), 0, F(i, 2), F(i, 3), 0, 0, 0, 1}}; // plane strain
        const auto one = sph::identity<double, 3>(), E = 0.5 * (transpose(f) * f - one);
        const auto cauchy = f * (lambda * trace(E) * one + 2 * G * E) * transpose(f) / determinant(f);
        const auto deviator = cauchy - trace(cauchy) / 3 * one;
        const double mises = std::sqrt(1.5 * trace(deviator * deviator));
        found.mean += mises / plate.size();
        found.greatest = std::max(found.greatest, mises);
    }
    return found;
}

/// Over the steps of a part of the run, Pa.
struct Stress {
    double mean;              ///< over plate and steps
    double greatest_mean;     ///< of the means over the plate
    double greatest_anywhere; ///< of all particles
    long long steps;
    void add(const Mises& seen) {
        mean += (seen.mean - mean) / static_cast<double>(++steps);
        greatest_mean = std::max(greatest_mean, seen.mean);
        greatest_anywhere = std::max(greatest_anywhere, seen.greatest);
    }
};

struct Spin {
    double momentum_start, momentum_drift, energy_drift; ///< kg m^2/s; shares of the start's
    double turned;                                       ///< turns of a corner
    double early, late;                                  ///< greatest radius in the first fifth and afterwards, m
    Stress stress_early, stress_late;                    ///< likewise, in rho omega^2 R^2, R half the diagonal
    long long steps;
};

inline Spin spin(int across, int turns) {
    const double spacing = 1.0 / across, omega = 50;
    PlateScene scene({.support_radius = 2 * spacing, .cfl = 0.4, .threads = 1});
    auto view = scene[scene.add(elastic<ElasticPlate>(1.7e7, 0.45, 1100),
                                sph::fill(sph::Box<2>{{-0.5, -0.5}, {0.5, 0.5}}, spacing), spacing)];
    for (int i = 0; i < view.size(); ++i) {
        const double x = view[sph::position](i, 0), y = view[sph::position](i, 1);
        view[sph::velocity].row(i) << -omega * y, omega * x;
    }
    Spin seen{};
    seen.momentum_start = angular_momentum(view);
    const double energy_start = sph::kinetic_energy(view), end = turns * 2 * std::numbers::pi / omega;
    double angle = 0, before = 0;
    scene.run_until(end, [&](const auto& s) {
        seen.momentum_drift = std::max(seen.momentum_drift, std::abs(angular_momentum(view) / seen.momentum_start - 1));
        const double energy = sph::kinetic_energy(view) + sph::elastic_energy<2>(view);
        if (s.steps() > 0) {
            seen.energy_drift = std::max(seen.energy_drift, std::abs(energy / energy_start - 1));
            (s.time() < end / 5 ? seen.stress_early : seen.stress_late).add(von_mises(view));
        }
        double& greatest = s.time() < end / 5 ? seen.early : seen.late;
        greatest = std::max(greatest, view[sph::position].rowwise().norm().maxCoeff());
        for (int i = 0; i < view.size(); ++i)
            if (view.ids()[static_cast<std::size_t>(i)] == 0) {
                const double now = std::atan2(view[sph::position](i, 1), view[sph::position](i, 0));
                angle += s.steps() > 0 ? std::remainder(now - before, 2 * std::numbers::pi) : 0;
                before = now;
            }
    });
    for (Stress* stress : {&seen.stress_early, &seen.stress_late})
        for (double* value : {&stress->mean, &stress->greatest_mean, &stress->greatest_anywhere})
            *value /= 1100 * sph::sq(omega) * 0.5;
    seen.turned = angle / (2 * std::numbers::pi);
    seen.steps = scene.steps();
    return seen;
}

inline std::vector<Measured> measure(int across) {
    const Spin seen = spin(across, 10);
    return {
        {"angular momentum, greatest drift in ten turns", "0.1 %", 1 + seen.momentum_drift, 1},
        {"energy, greatest drift in ten turns", "1 %", 1 + seen.energy_drift, 1},
        {"greatest radius after the second turn, share of that before", "it does not grow", seen.late / seen.early, 1},
        {"1 + growth of the von Mises stress after the second turn, its mean, rho omega^2 R^2", "1 %",
         1 + seen.stress_late.mean - seen.stress_early.mean, 1},
        {"the same, the greatest of its means over the plate", "1 %",
         1 + seen.stress_late.greatest_mean - seen.stress_early.greatest_mean, 1},
        {"the same, the greatest anywhere", "1 %",
         1 + seen.stress_late.greatest_anywhere - seen.stress_early.greatest_anywhere, 1}};
}

} // namespace validation::spinning_plate
