// One row of pores of the paper's sponge, r = 1.5 mm, under 14 mm of water that falls on it (presets/sponge.hpp has the
// full scene). Measured: the mean displacement of the sponge over 0.5 s, mm, and its greatest value.
#pragma once

#include "run.hpp"

#include <imbibe/presets/sponge_case.hpp>

namespace couplings::sponge {

constexpr double end = 0.5;

template <class Kit>
Outcome run_with(const Numerics& numerics) {
    sph::presets::SpongeCase c;
    c.strip = true;
    c.pool = 14e-3;
    c.pore_radius = 1.5e-3;
    c.water_spacing = numerics.spacing;
    c.search_interval = 4;
    c.threads = 1;
    const Load load{1000 * c.gravity * c.pool, std::sqrt(2 * c.gravity * c.gap)};
    const double support = numerics.ratio * c.water_spacing;
    auto settings = c.settings(support);
    settings.cfl = numerics.cfl;
    Scene<3, float, Kit> scene(settings);
    const auto pool = scene.add(water(10 * c.fall_speed()), c.water(), c.water_spacing);
    const auto slab = scene.add(elastic<Kit>(c.young_modulus, c.poisson_ratio, 950, 2 * c.solid_spacing), c.sponge(),
                                c.solid_spacing);
    scene.hold(slab, [&](const auto& x) { return c.clamped(x); });
    scene.add(Walls{{.density = 1000}}, c.vessel(support), c.water_spacing);
    couple<Kit>(scene, load, {support, c.water_spacing, c.solid_spacing, 3});
    const sph::DisplacementProbe<3> probe(scene[slab]);
    Outcome outcome = run<Kit>(
        scene, end, 200, [&](const auto& s) { return 1e3 * probe.mean(s[slab]); },
        [&](auto& s, double) {
            if (s.steps() % 20 == 0)
                s.remove_if(pool, [&](const auto& x) { return x[2] < -c.drain; });
        });
    if (outcome.failure.empty())
        outcome.value = *std::max_element(outcome.curve.begin(), outcome.curve.end());
    return outcome;
}

} // namespace couplings::sponge
