// A drop of liquid that swings in a gas of a hundredth or a thousandth of its density.
//
// Reference: Lamb (1932); in 2D omega^2 = 6 sigma/((rho + rho_o) R^3); Laplace's pressure sigma/R.
// Geometry: a drop of R = rho = sigma = 1, an ellipse of 1.06 R along x, in a box of 4 R, both of the kinematic
// viscosity 0.01.
// Scheme: presets::TwoLiquids from a square lattice; sound of the liquid is 20, rho c^2 of both the same.
// Measure: the time from the first to the third passage of <x^2 - y^2> through 0; the pressure within R/2 less that
// beyond 1.5 R, the mean until then.
#pragma once

#include "case.hpp"
#include "sessile_drop.hpp"

#include <imbibe/core/error.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace validation::drop_in_gas {

namespace sph = imbibe;
using sessile_drop::Preset;

constexpr double kinematic = 0.01, side = 4, stretch = 1.06;

/// What the drop does.
struct Swing {
    double period = 0;   ///< over that of the reference
    double pressure = 0; ///< over sigma/R
};

/// With so many particles over the radius, in a gas of 1/ratio of its density.
inline Swing swing(double across, double ratio) {
    const double spacing = 1 / across;
    const sessile_drop::Point middle(0.5 * side, 0.5 * side);
    auto scene = sessile_drop::drop(
        {side, side}, spacing, {.viscosity = kinematic, .lighter = ratio}, [&](const sessile_drop::Point& x) {
            return std::hypot((x[0] - middle[0]) / stretch, (x[1] - middle[1]) * stretch) < 1;
        });
    const auto drop = scene.get<Preset::Water>();
    const double radius = spacing * std::sqrt(static_cast<double>(drop.size()) / std::numbers::pi);
    drop[sph::density].array() *= 1 + 1 / (radius * sph::sq(sessile_drop::sound));
    drop[sph::mass].array() *= 1 + 1 / (radius * sph::sq(sessile_drop::sound));
    const double exact = 2 * std::numbers::pi / std::sqrt(6 / ((1 + 1 / ratio) * sph::power<3>(radius)));

    Swing seen;
    std::vector<double> passages;
    double before = 0, earlier = 0;
    int times = 0;
    while (passages.size() < 3 && scene.time() < 3 * exact) {
        scene.step();
        seen.pressure += sessile_drop::mean_pressure(scene.get<Preset::Water>(), middle, 0, 0.5) -
                         sessile_drop::mean_pressure(scene.get<Preset::Oil>(), middle, 1.5, side);
        ++times;
        const auto x = scene.get<Preset::Water>()[sph::position];
        const auto square = [&](int d) { return (x.col(d).array() - x.col(d).mean()).square().mean(); };
        const double mode = square(0) - square(1);
        if (before * mode < 0)
            passages.push_back(earlier + (scene.time() - earlier) * before / (before - mode));
        before = mode, earlier = scene.time();
    }
    seen.period = passages.size() < 3 ? 0 : (passages[2] - passages[0]) / exact;
    seen.pressure *= radius / times;
    return seen;
}

inline std::vector<Measured> measure(int across) {
    std::vector<Measured> found;
    for (const double ratio : {100.0, 1000.0}) {
        const Swing seen = swing(across, ratio);
        found.push_back({sph::text("period at ", ratio, " to 1"), "3 % at 16", seen.period, 1});
        found.push_back({sph::text("pressure over sigma/R at ", ratio, " to 1"), "5 % at 16", seen.pressure, 1});
    }
    return found;
}

} // namespace validation::drop_in_gas
