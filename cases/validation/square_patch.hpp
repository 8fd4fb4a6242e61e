// A square patch of water that rotates without gravity, viscosity and walls: tension in the middle, four corners that
// grow into arms.
//
// Reference: the pressure at the start solves Laplacian p = 2 rho omega^2 with p = 0 on the sides (a double sine
// series; Colagrossi 2005): -0.147343 rho omega^2 L^2 in the centre, -0.114670 at (L/4, L/2). Angular momentum and
// energy stay what they are.
// Geometry: L = 1, omega = 1, rho = 1, a square lattice.
// Scheme: Wendland C2 of 3 spacings, density diffusion, shifting, which keeps the particles together under tension;
// sound is 15 omega L.
// Measure: the pressures at the two places, which turn with the patch, from the particles within 2 spacings: the
// parabola p + q t^2 that fits 0.05 < omega t < 0.5 best. The patch starts with the pressure of the series, else it
// rings like a bell. At omega t = 2: angular momentum, energy, and the fewest neighbours a particle inside has.
#pragma once

#include "case.hpp"
#include "free_surface.hpp"

#include <array>
#include <numbers>

namespace validation::square_patch {

using K = sph::WendlandC2;
struct Patch : Water<K, sph::ParticleShifting<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Patch>;

struct Turn {
    std::array<double, 2> pressure;  ///< at the centre and at (L/4, L/2), rho omega^2 L^2
    double angular_momentum, energy; ///< as a share of the start's
    double lightest, densest;        ///< sum of V W over the neighbours, at the particles inside
};

/// The pressure at the start, rho omega^2 L^2, at a place from the middle, L.
inline double first_pressure(double x, double y) {
    const double pi = std::numbers::pi;
    double sum = 0;
    for (int m = 1; m < 60; m += 2)
        for (int n = 1; n < 60; n += 2)
            sum -= 32 / (m * n * sph::sq(sph::sq(pi)) * (m * m + n * n)) * std::sin(m * pi * (x + 0.5)) *
                   std::sin(n * pi * (y + 0.5));
    return sum;
}

inline Turn turn(int across, double end = 2) {
    const double spacing = 1.0 / across, H = 3 * spacing, sound = 15;
    Scene scene({.support_radius = H, .cfl = 0.4, .threads = 1});
    auto view = scene[scene.add(Patch{{.density = 1, .sound_speed = sound}},
                                sph::fill(sph::Box<2>{{-0.5, -0.5}, {0.5, 0.5}}, spacing), spacing)];
    for (int i = 0; i < view.size(); ++i) {
        const double x = view[sph::position](i, 0), y = view[sph::position](i, 1);
        view[sph::velocity].row(i) << y, -x;
        view[sph::density](i) += first_pressure(x, y) / sph::sq(sound);
    }
    const auto energy = [&] { return sph::kinetic_energy(view) + sph::compression_energy(view); };
    const double momentum_start = angular_momentum(view), energy_start = energy();

    std::array<std::vector<Eigen::Vector2d>, 2> samples; // t^2 and p
    scene.run_until(end, [&](const Scene& s) {
        if (s.time() < 0.05 || s.time() > 0.5)
            return;
        const auto x = view[sph::position];
        const std::array<Eigen::RowVector2d, 2> places{
            Eigen::RowVector2d(0, 0), 0.25 * Eigen::RowVector2d(-std::cos(s.time()), std::sin(s.time()))};
        for (std::size_t k = 0; k < 2; ++k) {
            double sum = 0, number = 0;
            for (int i = 0; i < view.size(); ++i)
                if ((x.row(i) - places[k]).squaredNorm() < sph::sq(2 * spacing)) {
                    sum += view[sph::pressure](i);
                    ++number;
                }
            samples[k].push_back({sph::sq(s.time()), sum / number});
        }
    });
    Turn seen{};
    for (std::size_t k = 0; k < 2; ++k) {
        Eigen::Vector2d mean(0, 0);
        for (const auto& at : samples[k])
            mean += at / static_cast<double>(samples[k].size());
        double tt = 0, tp = 0;
        for (const auto& at : samples[k]) {
            tt += sph::sq(at[0] - mean[0]);
            tp += (at[0] - mean[0]) * (at[1] - mean[1]);
        }
        seen.pressure[k] = mean[1] - tp / tt * mean[0];
    }
    seen.angular_momentum = angular_momentum(view) / momentum_start;
    seen.energy = energy() / energy_start;
    seen.lightest = 1e30;
    const auto x = view[sph::position];
    for (int i = 0; i < view.size(); ++i)
        if (view[sph::surface_nearness](i) == 0) {
            double sum = 0;
            for (int j = 0; j < view.size(); ++j)
                if (const double r = (x.row(i) - x.row(j)).norm(); r < H)
                    sum += spacing * spacing * sph::kernel_value<K, 2>(r, H);
            seen.lightest = std::min(seen.lightest, sum);
            seen.densest = std::max(seen.densest, sum);
        }
    return seen;
}

inline std::vector<Measured> measure(int across) {
    const Turn seen = turn(across);
    return {{"pressure in the centre, rho omega^2 L^2", "none given", seen.pressure[0], -0.147343},
            {"pressure at (L/4, L/2)", "none given", seen.pressure[1], -0.114670},
            {"angular momentum at omega t = 2, share of the start's", "0.1 %", seen.angular_momentum, 1},
            {"energy at omega t = 2, share of the start's", "none given", seen.energy, 1},
            {"fewest neighbours inside at omega t = 2 (sum of V W)", "no tear", seen.lightest, 1}};
}

} // namespace validation::square_patch
