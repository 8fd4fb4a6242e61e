// Water pushes a rubber gate open: Antoci, Gallati and Sibilla (2007), as in examples/elastic_gate.cpp. Measured: how
// far aside the gate's lower end goes until 0.16 s, mm; 45 in the experiment.
#pragma once

#include "run.hpp"

namespace couplings::gate {

constexpr double gravity = 9.81, width = 0.1, depth = 0.14, thickness = 5e-3, height = 79e-3, end = 0.16;
constexpr Load load{1000 * gravity * depth, 0.5};

template <class Kit>
Outcome run_with(const Numerics& numerics) {
    const double dx = numerics.spacing, support = numerics.ratio * dx;
    const double root = dx / 2 + height + 3 * dx; // held, above what is free to move
    const Layers layers{support, dx, dx, 2};
    Scene<2, float, Kit> scene(
        {.gravity = {0, -gravity}, .support_radius = support, .cfl = numerics.cfl, .search_interval = 4, .threads = 1});
    // Whole columns of water, the last of which is where it has to be: `fill` would put them in the middle.
    const double last = width - Kit::first_gap(load, layers), first = last - std::floor(last / dx + 1e-9) * dx;
    const auto pool = scene.add(water(10 * std::sqrt(2 * gravity * depth)),
                                sph::fill(sph::Box<2>{{first, 0}, {last, depth}}, dx), dx);
    // Its support is never wider than the water's: that between the two is the wider one, and what is varied.
    const double young = sph::bending_modulus(1.2e7, static_cast<int>(std::lround(thickness / dx)));
    const auto gate = scene.add(elastic<Kit>(young, 0.4, 1100, 2 * dx),
                                sph::fill(sph::Box<2>{{width, dx / 2}, {width + thickness, root}}, dx), dx);
    scene.hold(gate, [&](const auto& x) { return x[1] > dx / 2 + height; });
    auto walls = sph::tank(sph::Box<2>{{0, 0}, {4 * width, 0.2}}, dx, 3, sph::Sides::y_high);
    for (const auto& x : sph::fill(sph::Box<2>{{width, root}, {width + thickness, 0.2}}, dx))
        walls.push_back(x);
    scene.add(Walls{{.density = 1000}}, walls, dx);
    couple<Kit>(scene, load, layers);
    const auto aside = [&](const auto& s) {
        const auto x = s[gate][sph::position], X = s[gate][sph::reference_position];
        double sum = 0;
        int number = 0;
        for (int i = 0; i < s[gate].size(); ++i)
            if (X(i, 1) < 1.5 * dx) {
                sum += x(i, 0) - X(i, 0);
                ++number;
            }
        return 1e3 * sum / number;
    };
    Outcome outcome = run<Kit>(scene, end, 64, aside, [&](auto& s, double) {
        s.remove_if(pool, [&](const auto& x) { return x[0] > 4 * width - 2 * dx; });
    });
    if (outcome.failure.empty())
        outcome.value = *std::max_element(outcome.curve.begin(), outcome.curve.end());
    return outcome;
}

} // namespace couplings::gate
