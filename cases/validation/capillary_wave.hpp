// A small wave on the flat interface of two liquids, which their tension drives and their viscosity damps.
//
// Reference: exact, Prosperetti (1981), for two liquids of the same density and viscosity.
// Geometry: wave length = rho = sigma = 1, a height of 1 of each liquid, an amplitude of 0.02, viscosity 0.01.
// Scheme: presets::TwoLiquids on a square lattice that is shifted as the wave moves it; sound is 20.
// Measure: the mode of the lower liquid, a = 2 sum_b V_b cos(k x_b): its period from the first to the fifth passage
// through 0, and its first trough over where it began.
#pragma once

#include "case.hpp"

#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/presets/two_liquids.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace validation::capillary_wave {

namespace sph = imbibe;
using Preset = sph::presets::TwoLiquids;

constexpr double k = 2 * std::numbers::pi, viscosity = 0.01, amplitude = 0.02, sound = 20;

/// What is read off a wave.
struct Wave {
    double period = 0; ///< from the first to the fifth passage through 0, halved
    double trough = 0; ///< the first, over the start
};
inline Wave read_off(const std::vector<double>& times, const std::vector<double>& mode) {
    Wave wave;
    std::vector<double> passages;
    for (std::size_t i = 1; i < mode.size(); ++i) {
        wave.trough = passages.size() < 2 ? std::min(wave.trough, mode[i] / mode[0]) : wave.trough;
        if (mode[i - 1] * mode[i] < 0)
            passages.push_back(times[i - 1] + (times[i] - times[i - 1]) * mode[i - 1] / (mode[i - 1] - mode[i]));
    }
    wave.period = passages.size() < 5 ? 0 : 0.5 * (passages[4] - passages[0]);
    return wave;
}

/// Prosperetti's wave. Its roots z are those of z^4 - e z^3 - e^2 z^2 + e^3 z + omega^2, e = k sqrt(nu).
inline Wave exact() {
    using Complex = std::complex<double>;
    const double e = k * std::sqrt(viscosity), square = 0.5 * k * k * k * std::tanh(k);
    std::array<Complex, 4> z;
    for (std::size_t i = 0; i < 4; ++i)
        z[i] = std::polar(std::pow(square, 0.25), 0.4 + 0.5 * std::numbers::pi * static_cast<double>(i));
    const auto others = [&](std::size_t i) { // the product of z_j - z_i
        Complex product = 1;
        for (std::size_t j = 0; j < 4; ++j)
            product *= j == i ? 1.0 : z[j] - z[i];
        return product;
    };
    for (int turn = 0; turn < 100; ++turn) // Durand and Kerner
        for (std::size_t i = 0; i < 4; ++i)
            z[i] += ((((z[i] - e) * z[i] - e * e) * z[i] + e * e * e) * z[i] + square) / others(i);
    const auto scaled_erfc = [](const Complex& x) { // exp(x^2) erfc(x) = 2/sqrt(pi) int exp(-u^2 - 2 x u) du
        Complex sum = 0;
        const int steps = 4000;
        const double longest = 14;
        for (int i = 0; i < steps; ++i) {
            const double u = longest * (i + 0.5) / steps;
            sum += std::exp(-u * u - 2.0 * x * u);
        }
        return sum * (longest / steps * 2 / std::sqrt(std::numbers::pi));
    };
    std::vector<double> times, mode;
    for (int i = 0; i <= 750; ++i) {
        const double t = 0.002 * i;
        Complex sum = 0;
        for (std::size_t j = 0; j < 4; ++j)
            sum += z[j] / others(j) * square / (z[j] * z[j] - e * e) * std::exp(-e * e * t) *
                   scaled_erfc(z[j] * std::sqrt(t));
        times.push_back(t), mode.push_back(sum.real());
    }
    return read_off(times, mode);
}

/// Two layers of particles, each 1 high and 1 wide, whose interface at y = 0 is shifted by an amplitude times cos(k x),
/// and all else as a wave of small amplitude moves it.
struct Layers {
    std::vector<Eigen::Vector2d> below, above; ///< m
};
inline Layers layers(double spacing, double amplitude_of_wave) {
    Layers found;
    for (auto x : sph::fill(sph::Box<2>({0, -1}, {1, 1}), spacing)) {
        const bool is_below = x[1] < 0;
        const double rise = amplitude_of_wave * std::exp(-k * std::abs(x[1])), phase = k * x[0];
        x[0] += (is_below ? -rise : rise) * std::sin(phase);
        x[1] += rise * std::cos(phase);
        (is_below ? found.below : found.above).push_back(x);
    }
    return found;
}

/// The wave in particles, so many in its length.
inline Wave wave(double across) {
    const double spacing = 1 / across;
    Preset::Scene<2, double> scene(
        {.support_radius = 3 * spacing, .cfl = 0.4, .periodic_length = {1, 0}, .threads = 1});
    const Preset::Interface interface { .surface_tension = 1 };
    Preset::Water water{{.density = 1, .sound_speed = sound, .viscosity = viscosity}};
    Preset::Oil oil{{.density = 1, .sound_speed = sound, .viscosity = viscosity}};
    Preset::set_coefficients(water, interface, spacing);
    Preset::set_coefficients(oil, interface, spacing);
    const auto [below, above] = layers(spacing, amplitude);
    scene.add(water, below, spacing);
    scene.add(oil, above, spacing);
    scene.add(Preset::Vessel{{.density = 1}}, sph::tank(sph::Box<2>({0, -1}, {1, 1}), spacing, 4, sph::Sides::x),
              spacing);
    Preset::set_coefficients(scene, interface);
    std::vector<double> times, mode;
    scene.run_until(1.6, [&](const auto& s) {
        const auto x = s.template get<Preset::Water>()[sph::position];
        times.push_back(s.time());
        mode.push_back(2 * spacing * spacing * (k * x.col(0).array()).cos().sum());
    });
    return read_off(times, mode);
}

inline std::vector<Measured> measure(int across) {
    const Wave found = wave(across), right = exact();
    return {{"period", "4 % with 64", found.period, right.period},
            {"first trough over the start", "2 % with 64", found.trough, right.trough}};
}

} // namespace validation::capillary_wave
