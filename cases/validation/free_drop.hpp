// A drop of one liquid, with nothing around it: its oscillation, its pressure, its rest.
//
// Reference: Lamb (1932); the period 2 pi sqrt(rho R^3/(k sigma)) of the second mode, k = 6 in the plane, 8 in space;
// Laplace's pressure sigma/R (2 sigma/R); in the plane damping at the rate 4 nu/R^2, and a square that becomes a disc.
// Geometry: a disc or ball of R = 1 and a square of the same area, cut from a lattice; rho = sigma = 1, viscosity 0.01.
// Scheme: CohesiveFluid, settled; sound is 20. It begins with the velocity 0.2 (x, -y) or 0.2 (x, -y/2, -z/2).
// Measure: the mean of the half periods in 8 time units, or 4 in space, by the second moment of the positions; the fall
// of its peaks; the mean of LiquidPressure within 0.75 less 6.25 spacings of the middle, at least 2 spacings.
#pragma once

#include "case.hpp"

#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/interface/liquid_pressure.hpp>
#include <imbibe/interface/settle_surface.hpp>
#include <imbibe/methods/cohesive_fluid.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace validation::free_drop {

namespace sph = imbibe;

constexpr double pi = std::numbers::pi;

struct Water : sph::Fluid<sph::CohesiveFluid, sph::MorrisViscosity<sph::WendlandC6>, sph::LiquidPressure> {};
template <int dim>
using Scene = sph::Solver<dim, double, sph::SymplecticEuler, Water>;

/// The part of a lattice in which `inside(x)`, settled. @param across particles over the radius
template <int dim>
Scene<dim> drop(double across, double viscosity, const auto& inside) {
    const double spacing = 1 / across;
    Scene<dim> scene({.support_radius = 5 * spacing, .threads = 1});
    Water water{{.density = 1, .sound_speed = 20, .viscosity = viscosity}};
    water.set(sph::CohesionParameters{.surface_tension = 1});
    std::vector<sph::Point<dim>> points;
    using Point = sph::Point<dim>;
    for (const auto& x : sph::fill(sph::Box<dim>(Point::Constant(-1.5), Point::Constant(1.5)), spacing))
        if (inside(x))
            points.push_back(x);
    scene.add(water, points, spacing);
    sph::settle_surface<Water>(scene);
    return scene;
}

/// The radius of a disc or a ball of as many particles.
template <int dim>
double radius_of(const Scene<dim>& scene) {
    const auto water = scene.template get<Water>();
    const double volume = water[sph::mass].sum();
    return dim == 2 ? std::sqrt(volume / pi) : std::cbrt(0.75 * volume / pi);
}

/// What a drop did.
struct Swings {
    double period = 0;   ///< over Lamb's
    double damping = 0;  ///< the rate at which its swings become smaller, over that of viscosity in the plane
    double pressure = 0; ///< over Laplace's
};
/// With so many particles over its radius, for some time.
template <int dim>
Swings swing(double across, double time, double viscosity = 0.01) {
    auto scene = drop<dim>(across, viscosity, [](const auto& x) { return x.norm() < 1; });
    const double R = radius_of(scene), begin = scene.time();
    auto&& water = scene.template get<Water>();
    for (int d = 0; d < dim; ++d)
        water[sph::velocity].col(d) = (d == 0 ? 0.2 : -0.2 / (dim - 1)) * water[sph::position].col(d).eval();
    std::vector<double> times, moments, crossings, peaks;
    double pressure = 0, particles = 0, peak = 0;
    scene.run_until(begin + time, [&](const Scene<dim>& s) {
        const auto view = s.template get<Water>();
        const auto x = view[sph::position];
        const auto away = (x.rowwise() - x.colwise().mean()).eval();
        double moment = away.col(0).squaredNorm();
        for (int d = 1; d < dim; ++d)
            moment -= away.col(d).squaredNorm() / (dim - 1);
        if (!moments.empty() && moment * moments.back() < 0) {
            const double share = moments.back() / (moments.back() - moment);
            crossings.push_back(times.back() + share * (s.time() - times.back()));
            peaks.push_back(peak);
            peak = 0;
        }
        peak = std::max(peak, std::abs(moment));
        times.push_back(s.time());
        moments.push_back(moment);
        for (int i = 0; i < view.size(); ++i)
            if (away.row(i).norm() < std::max(0.75 - 6.25 / across, 2 / across)) {
                pressure += view[sph::liquid_pressure](i);
                ++particles;
            }
    });
    const std::size_t last = crossings.size() - 1;
    const double half = (crossings[last] - crossings[0]) / static_cast<double>(last);
    Swings seen;
    seen.period = 2 * half / (2 * pi * std::sqrt(sph::power<3>(R) / (dim == 2 ? 6 : 8)));
    seen.damping =
        std::log(peaks[1] / peaks[last]) / (half * static_cast<double>(last - 1)) / (4 * viscosity / sph::sq(R));
    seen.pressure = pressure / particles * R / (dim - 1);
    return seen;
}

/// What becomes of a square with the area of a disc of R = 1.
struct Rounded {
    double least = 0, most = 0; ///< distance of the outermost particle of a direction from the middle, over their mean
    double speed = 0;           ///< the greatest, sqrt(sigma/(rho R))
};
inline Rounded square(double across) {
    auto scene = drop<2>(across, 0.1, [](const auto& x) { return x.cwiseAbs().maxCoeff() < 0.5 * std::sqrt(pi); });
    scene.run_until(scene.time() + 20);
    const auto water = scene.template get<Water>();
    const auto x = water[sph::position];
    const auto away = (x.rowwise() - x.colwise().mean()).eval();
    std::vector<double> farthest(24, 0);
    for (int i = 0; i < water.size(); ++i) {
        const double angle = std::atan2(away(i, 1), away(i, 0));
        double& far = farthest[static_cast<std::size_t>(std::min(23.0, (angle + pi) / (2 * pi) * 24))];
        far = std::max(far, away.row(i).norm());
    }
    double mean = 0;
    for (double far : farthest)
        mean += far / 24;
    const auto [least, most] = std::minmax_element(farthest.begin(), farthest.end());
    return {*least / mean, *most / mean, water[sph::velocity].rowwise().norm().maxCoeff()};
}

inline std::vector<Measured> measure(int across) {
    const auto seen = swing<2>(across, 8);
    const auto round = square(across);
    return {{"period over Lamb's", "3 % from 16 on", seen.period, 1},
            {"damping over 4 nu/R^2", "none given", seen.damping, 1},
            {"pressure over sigma/R", "5 % at 16", seen.pressure, 1},
            {"a square's least radius over the mean", "3 %", round.least, 1},
            {"a square's greatest radius over the mean", "3 %", round.most, 1},
            {"1 + greatest speed at rest", "1 %", 1 + round.speed, 1}};
}
inline std::vector<Measured> measure_ball(int across) {
    const auto seen = swing<3>(across, 4);
    return {{"period over Lamb's", "5 % at 12", seen.period, 1},
            {"pressure over 2 sigma/R", "none given", seen.pressure, 1}};
}

} // namespace validation::free_drop
