// Too many neighbours for a kernel: do particles pair up? Row 2 of the gauntlet.
#pragma once

#include "fluids.hpp"

namespace stability {

template <class K>
struct Crowd
    : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>, sph::MonaghanViscosity<K>> {};

/// A periodic square of water under pressure, a little disordered, whose support is 4 spacings: 50 neighbours.
template <class K>
Outcome crowded(const Plan& plan) {
    const double c = 30;
    sph::Solver<2, double, sph::SymplecticEuler, Crowd<K>> scene(
        {.support_radius = 4 * dx, .periodic_length = {16 * dx, 16 * dx}, .threads = 1});
    const auto lattice = sph::fill(sph::Box<2>{{0, 0}, {16 * dx, 16 * dx}}, dx);
    Crowd<K> material{{.density = 1000, .sound_speed = c}};
    material.set(sph::MonaghanViscosityParameters{.alpha = 0.1});
    const auto water = scene.add(material, sph::jitter<2>(lattice, 0.1 * dx, 3), dx);
    scene[water][sph::density].setConstant(1050);
    const Watch<2> watch{.end = 600 * dx / c,
                         .guard = {.energy = std::numeric_limits<double>::infinity()},
                         .signs = {{"spacings over the least distance of a pair", 1 / 0.3}},
                         .every = 20,
                         .expected_steps = 600};
    return march(scene, plan, watch, [&](const auto& s) { return std::vector{1 / closest_pair(s[water])}; });
}

} // namespace stability
