// Creeping flow through one round pore in a plate: what drains a sponge.
//
// Reference: Dagan, Weinbaum and Pfeffer (1982): the pressure that drives Q through a pore of radius a in a plate of
// thickness L between two half spaces is Dp a^3/(mu Q) = 3 + 8 L/(pi a), within 1 %.
// Geometry: a and nu are 1, L = 2 a. Cubic lattice, periodic in all directions: pores are 8 a apart, and plates 6 a.
// What the neighbouring pores take off the 3 is not corrected for.
// Scheme: that of creeping.hpp; sound is 30 nu/a, a thousand times the speed in the pore. The liquid starts with the
// pressure with which it ends, but for what the flow near the pore makes of it: otherwise it would ring for long.
// Measure: rho f (L + 6 a) a^3/(mu Q): a body force on all of the liquid drives as a pressure drop of rho f a period.
// Q is the mean flux along the plates' normal over 2.5 a^2/nu, in which the liquid between two plates rings once
// through the pore, when it is the same to 0.5 % as in the 2.5 before.
#pragma once

#include "creeping.hpp"

#include <numbers>

namespace validation::one_pore {

constexpr double thickness = 2, apart = 8, space = 6; // of the radius

/// Dp a^3/(mu Q). @param resolution spacings in the radius, @param support in spacings
template <class K = sph::QuinticSpline, class Real = float>
double resistance(int resolution, double support = 3, int threads = 1) {
    const double spacing = 1.0 / resolution, period = thickness + space, force = 0.1;
    const sph::Point<3> cell(apart, apart, period), along(0, 0, 1), middle = cell / 2;
    const auto lattice = sph::fill(sph::Box<3>{{0, 0, 0}, cell}, spacing);
    std::vector<sph::Point<3>> slab; // the plate without its pore, in which the pore is to take its share
    creeping::Parts<3> parts;
    for (const auto& x : lattice)
        (std::abs(x[2] - middle[2]) < thickness / 2 ? slab : parts.liquid).push_back(x);
    const auto pore = creeping::part<3>(slab, spacing, middle, std::numbers::pi * thickness,
                                        [](const auto& x) { return std::hypot(x[0], x[1]) < 1; });
    parts.liquid.insert(parts.liquid.end(), pore.obstacle.begin(), pore.obstacle.end());
    // Only what can be seen of the plate has to be there.
    for (const auto& x : pore.liquid)
        if (std::hypot(x[0] - middle[0], x[1] - middle[1]) < 1 + (support + 1) * spacing ||
            thickness / 2 - std::abs(x[2] - middle[2]) < (support + 0.5) * spacing)
            parts.obstacle.push_back(x);
    constexpr double c = 30;
    auto scene = creeping::scene_of<K, Real, 3>(parts, cell, force * along, spacing, support, c, threads);
    const auto liquid = scene[sph::PhaseHandle<creeping::Liquid<K>>{}];
    for (int i = 0; i < liquid.size(); ++i) {
        const double above = std::remainder(liquid[sph::position](i, 2) - middle[2], period); // of the plate's middle
        const double from_half_way = above - std::copysign(period / 2, above);
        const double head = std::abs(above) > thickness / 2 ? from_half_way : -above * space / thickness;
        liquid[sph::density](i) = static_cast<Real>(1 + force * head / (c * c));
    }
    const double Q = creeping::steady_flux<K>(scene, along, spacing, 2.5, 5e-3) / period;
    return force * period / Q;
}

inline std::vector<Measured> measure(int resolution) {
    return {{"Dp a^3/(mu Q), L = 2 a", "15 % at 4, 5 % at 8", resistance(resolution),
             3 + 8 * thickness / std::numbers::pi}};
}

} // namespace validation::one_pore
