// One run of a scene with one coupling: how it is watched, and what is kept of it.
#pragma once

#include "contacts.hpp"

#include <imbibe/accuracy/study.hpp>

#include <ctime>
#include <limits>
#include <string>
#include <vector>

namespace couplings {

/// What is varied.
struct Numerics {
    double spacing; ///< of the water, m
    double ratio;   ///< support radius of the water in spacings
    double cfl;     ///< share of the shortest limit that a step takes
};

/// What came of a run.
struct Outcome {
    double value = std::numeric_limits<double>::quiet_NaN(); ///< what the scene measures; see there
    double step = 0;                                         ///< mean time step, s
    std::string limit;                                       ///< what limited the last one
    double seconds = 0;                                      ///< processor time
    double gap = 0;              ///< least distance of a particle of the water to one of the solid, mean spacings
    double pair_evaluations = 0; ///< the work, see imbibe::accuracy
    std::vector<double> curve;   ///< what the scene measures, at equal times
    std::string failure;         ///< why the run broke off, if it did
};

/// Runs a scene to `end`, s, and calls `look(scene)` for the curve at `samples` equal times; between steps `tend(scene,
/// step)`. The guard ends what has gone wrong.
template <class Kit, class Scene, class Look, class Tend>
Outcome run(Scene& scene, double end, int samples, const Look& look, const Tend& tend) {
    constexpr int dim = Scene::dimension;
    using Solid = Elastic<Kit>;
    Outcome outcome;
    const auto water = scene.template get<Water>();
    const auto solid = scene.template get<Solid>();
    const double mean_spacing = 0.5 * (water.material().spacing + solid.material().spacing);
    constexpr double farthest = 5; // spacings
    outcome.gap = farthest;
    sph::GuardSettings<dim> bounds;
    bounds.energy = std::numeric_limits<double>::infinity(); // scenes start under load
    sph::Guard<dim> guard(bounds);
    const std::clock_t begin = std::clock(); // of the processor: other programs on the machine do not count
    const double every = end / samples;
    try {
        while (scene.time() < end * (1 - 1e-9)) {
            const sph::TimeStepLimit limit = scene.next_step();
            outcome.limit = limit.reason + ", " + limit.where;
            const double step = std::min(limit.seconds, every * (double(outcome.curve.size()) + 1) - scene.time());
            scene.step(std::max(step, 1e-9 * end));
            tend(scene, step);
            guard(scene);
            if (scene.time() >= every * (double(outcome.curve.size()) + 1) * (1 - 1e-9)) {
                outcome.curve.push_back(look(scene));
                outcome.gap =
                    std::min(outcome.gap, least_distance<dim>(water, solid, farthest * mean_spacing) / mean_spacing);
            }
        }
        outcome.step = end / double(scene.steps());
        outcome.pair_evaluations = sph::accuracy::pair_evaluations(scene);
    } catch (const sph::Error& error) {
        outcome.failure = error.what();
    }
    outcome.seconds = double(std::clock() - begin) / CLOCKS_PER_SEC;
    return outcome;
}

} // namespace couplings
