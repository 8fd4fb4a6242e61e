// One run of the sponge in any composition of presets/sponge.hpp: include that of yours before this.
#pragma once

#include "sponge_run.hpp"

#include <imbibe/monitor/displacement.hpp>
#include <imbibe/monitor/energy.hpp>
#include <imbibe/output/run.hpp>

namespace imbibe::presets {
struct PaperSponge; // one file compiles one composition: the other's scene is not so much as looked at
}

namespace imbibe::example {

/// Where the water is that has left the tank.
struct Drained {
    int through = 0, over_the_rim = 0; ///< particles taken out of the scene
    int at_start = 0;                  ///< particles of water

    /// Takes out the water that has fallen far below the slab. What falls outside the tank has jumped over its rim, not
    /// gone through the sponge.
    template <class Scene, class Water>
    void remove(Scene& scene, PhaseHandle<Water> water, const presets::SpongeCase& numbers) {
        scene.remove_if(water, [&](const Point<3>& x) {
            const bool gone = x[2] < -numbers.drain;
            if (gone)
                ++(in_the_tank(numbers, x[0], x[1]) ? through : over_the_rim);
            return gone;
        });
    }
    /// The share of the water that is below the slab or has left through it.
    double share(const auto& water, const presets::SpongeCase& numbers) const {
        int n = through;
        const auto x = water[position];
        for (int i = 0; i < water.size(); ++i)
            n += x(i, 2) < 0 && in_the_tank(numbers, x(i, 0), x(i, 1));
        return static_cast<double>(n) / at_start;
    }
    /// What has gone through may spread by a part of a spacing below the walls, which are thicker than that.
    static bool in_the_tank(const presets::SpongeCase& numbers, double x, double y) {
        const double margin = numbers.water_spacing;
        return x > -margin && x < numbers.length() + margin &&
               (numbers.strip || (y > -margin && y < numbers.width() + margin));
    }
};

/// How far the sponge gives way: its greatest mean displacement, and the mean over the end of the run.
struct Sag {
    double greatest = 0, at = 0;                ///< m, s
    double late_from = 0, sum = 0, samples = 0; ///< s, m, 1

    void note(double time, double mean, double end) {
        if (mean > greatest)
            greatest = mean, at = time;
        if (late_from != 0.6 * end) // a run may be continued to a later end
            late_from = 0.6 * end, sum = samples = 0;
        if (time >= late_from)
            sum += mean, samples += 1;
    }
};

template <class C, class Real>
SpongeResult run_sponge(const presets::SpongeCase& numbers, const RunSettings& settings) {
    constexpr bool paper = std::is_same_v<C, presets::PaperSponge>;
    C::check(numbers);
    auto scene = C::template make<Real>(numbers);
    const PhaseHandle<typename C::Water> in_water;
    const auto water = scene[in_water];
    const auto sponge = scene.template get<typename C::Sponge>();
    const DisplacementProbe<3> probe(sponge, scene.settings());
    Drained drained{.at_start = water.size()};
    Sag sag;

    Run run(scene, settings);
    for (const RunNumber& number : numbers_by_option(numbers, paper))
        run.depends_on(number);
    run.depends_on({"the number of water particles at the start", static_cast<double>(water.size())});
    run.depends_on({"the number of sponge particles", static_cast<double>(sponge.size())});
    run.keep("drained", drained.through).keep("spilled", drained.over_the_rim);
    run.keep("peak", sag.greatest).keep("peak time", sag.at);
    run.keep("late from", sag.late_from).keep("late sum", sag.sum).keep("late samples", sag.samples);

    const auto& gravity = scene.settings().gravity;
    const double particle = 1000 * numbers.water_spacing * numbers.water_spacing * numbers.water_spacing; // kg
    const auto momentum_along = [&](int d) { return [&, d] { return (momentum(water) + momentum(sponge))[d]; }; };
    run.column("mean displacement", "m", [&] {
        const double mean = probe.mean(sponge);
        sag.note(scene.time(), mean, settings.end);
        return mean;
    });
    run.column("mean vertical displacement", "m", [&] { return probe.mean_vector(sponge)[2]; });
    run.column("greatest displacement", "m", [&] { return probe.greatest(sponge); });
    run.column("drained mass", "kg", [&] { return drained.share(water, numbers) * drained.at_start * particle; });
    run.column("drained fraction", "1", [&] { return drained.share(water, numbers); });
    run.column("kinetic energy of the water", "J", [&] { return kinetic_energy(water); });
    run.column("potential energy of the water", "J", [&] { return potential_energy(water, gravity); });
    run.column("compression energy of the water", "J", [&] { return compression_energy(water); });
    run.column("kinetic energy of the sponge", "J", [&] { return kinetic_energy(sponge); });
    run.column("potential energy of the sponge", "J", [&] { return potential_energy(sponge, gravity); });
    run.column("elastic energy of the sponge", "J", [&] { return stored_energy(sponge); });
    run.column("momentum along x", "kg m/s", momentum_along(0));
    run.column("momentum along y", "kg m/s", momentum_along(1));
    run.column("momentum along z", "kg m/s", momentum_along(2));
    run.column("least density of the water", "kg/m^3",
               [&] { return water.size() > 0 ? static_cast<double>(water[density].minCoeff()) : 0.0; });
    run.column("greatest density of the water", "kg/m^3",
               [&] { return water.size() > 0 ? static_cast<double>(water[density].maxCoeff()) : 0.0; });
    run.each([&](auto& now) {
        if (now.steps() % 20 == 0)
            drained.remove(now, in_water, numbers);
    });

    SpongeResult result;
    static_cast<RunOutcome&>(result) = run.go();
    result.composition = C::name;
    result.peak = sag.greatest;
    result.peak_time = sag.at;
    result.late_mean = sag.samples > 0 ? sag.sum / sag.samples : 0;
    result.drained = drained.share(water, numbers);
    result.spilled = static_cast<double>(drained.over_the_rim) / drained.at_start;
    result.conserved = water.size() + drained.through + drained.over_the_rim == drained.at_start;
    if (result.snapshots > 0)
        draw_pictures(settings.folder.string(), C::name);
    return result;
}

} // namespace imbibe::example
