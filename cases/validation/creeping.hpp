// What the cases of creeping flow through a rigid, periodic array share: the liquid, what it sticks to, and the mean
// velocity that a body force comes to.
//
// Scheme: MorrisViscosity with NoSlipVelocity and NoSlipViscosity at the walls, PressureExtrapolation in them. Without
// DensityDiffusion: what it lets pass down the gradient of the pressure is no small part of a flow as slow as this.
#pragma once

#include "sticky_walls.hpp"

#include <imbibe/accuracy/study.hpp>

#include <algorithm>

namespace validation::creeping {

template <class K>
struct Liquid
    : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>, sph::MorrisViscosity<K>> {};
struct Obstacle : sph::Wall<> {};
template <class K>
struct Contact : sph::Coupling<Liquid<K>, Obstacle, sph::Into<Obstacle, sph::PressureExtrapolation<K>>,
                               sph::VolumePressure<K>, sph::Into<Liquid<K>, sph::VolumeContinuity<K>>,
                               sph::Into<Obstacle, sph::NoSlipVelocity<K>>, sph::NoSlipViscosity<K>> {};
template <int dim, class K, class Real>
using Scene = sph::Solver<dim, Real, sph::SymplecticEuler, Liquid<K>, Obstacle, Contact<K>>;

/// The points of a lattice where the liquid is, and where the obstacle.
template <int dim>
struct Parts {
    std::vector<sph::Point<dim>> liquid, obstacle;
};

/// Parts the points of a lattice by `inside(x - centre)`, with the centre within half a spacing of `middle` where the
/// obstacle comes nearest to having `volume`: it then takes its share of the lattice.
template <int dim, class Inside>
Parts<dim> part(const std::vector<sph::Point<dim>>& lattice, double spacing, const sph::Point<dim>& middle,
                double volume, const Inside& inside) {
    constexpr int tries = 8;
    const double cell = std::pow(spacing, dim);
    Parts<dim> best;
    double least = 1e300;
    for (int k = 0; k < (dim == 2 ? tries * tries : tries * tries * tries); ++k) {
        sph::Point<dim> centre = middle;
        for (int d = 0, digits = k; d < dim; ++d, digits /= tries)
            centre[d] += digits % tries * spacing / (2 * tries);
        const auto taken = std::count_if(lattice.begin(), lattice.end(),
                                         [&](const auto& x) { return inside(sph::Point<dim>(x - centre)); });
        const double off = std::abs(static_cast<double>(taken) * cell - volume);
        if (off < least) {
            least = off;
            best = {};
            for (const auto& x : lattice)
                (inside(sph::Point<dim>(x - centre)) ? best.obstacle : best.liquid).push_back(x);
        }
    }
    return best;
}

/// A scene of such parts in a periodic cell with lower corner 0, driven by a body force; density, viscosity and what
/// else makes the units are 1.
template <class K, class Real, int dim>
Scene<dim, K, Real> scene_of(const Parts<dim>& parts, const sph::Point<dim>& cell, const sph::Point<dim>& force,
                             double spacing, double support, double sound_speed, int threads = 1, double cfl = 0.4) {
    sph::Settings<dim> settings{.support_radius = support * spacing, .cfl = cfl, .threads = threads};
    for (int d = 0; d < dim; ++d) {
        settings.gravity[static_cast<std::size_t>(d)] = force[d];
        settings.periodic_length[static_cast<std::size_t>(d)] = cell[d];
    }
    Scene<dim, K, Real> scene(settings);
    scene.add(Liquid<K>{{.density = 1, .sound_speed = sound_speed, .viscosity = 1}}, parts.liquid, spacing);
    scene.add(Obstacle{{.density = 1}}, parts.obstacle, spacing);
    return scene;
}

/// The sum of the liquid's velocities along `along`, times the volume of a particle.
template <class K, class SceneType, class Direction>
double flux(const SceneType& scene, const Direction& along, double spacing) {
    const auto v = scene[sph::PhaseHandle<Liquid<K>>{}][sph::velocity];
    const Eigen::Matrix<double, 1, SceneType::dimension> sum = v.template cast<double>().colwise().sum();
    return sum.dot(along) * std::pow(spacing, SceneType::dimension);
}

/// Runs until the flux, averaged over a time `apart`, changes by less than `change` of itself from one such time to the
/// next, and returns it. The mean leaves out what rings, if its period is no longer than that: else the crest of a wave
/// would be taken for rest.
template <class K, class SceneType, class Direction>
double steady_flux(SceneType& scene, const Direction& along, double spacing, double apart, double change = 3e-4) {
    double now = 0;
    for (double end = apart, before = -1; std::abs(now - before) > change * now || now <= 0; end += apart) {
        before = now;
        double sum = 0, last = scene.time();
        const double begin = last;
        scene.run_until(end, [&](const auto& s) {
            sum += flux<K>(s, along, spacing) * (s.time() - last);
            last = s.time();
        });
        now = sum / (end - begin);
    }
    return now;
}

} // namespace validation::creeping
