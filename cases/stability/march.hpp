// Runs a scene with steps that are a given share of its shortest limit, and says whether it stayed stable.
#pragma once

#include <imbibe/monitor/energy.hpp>
#include <imbibe/monitor/guard.hpp>
#include <imbibe/solid/volumetric_deviatoric.hpp>

#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace stability {

namespace sph = imbibe;

/// What a case is run with.
struct Plan {
    /// The length of a step, as a share of the shortest limit.
    double cfl = 0.4;
    /// The physical quantity of the case, where it has one: an impact speed, a density ratio, Poisson's ratio.
    double value = 0;
    /// Prints time, kinetic energy and signs about a hundred times.
    bool trace = false;
    /// Asks `longest_stable_step` before the run, where the scene is one that is shaken.
    bool ask = false;
};

/// What a case watches: a number, and the bound beyond which the case has failed.
struct Sign {
    std::string name;
    double bound;
    double worst = 0;
};

/// What came of a run.
struct Outcome {
    bool stable = true;
    std::string cause;   ///< of the failure, short
    std::string message; ///< what Diverged or Error said
    std::vector<Sign> signs;
    /// Energy at the end less that at the start, as a share of the greatest kinetic energy; not a number where the
    /// energy that the scene stores is not known.
    double energy_drift = 0;
    std::string limit; ///< the reason that limited most steps
    double share = 0;  ///< how many of them, as a share
    long long steps = 0;
    double asked = 0; ///< what `longest_stable_step` said, as a share of the shortest limit; 0: it was not asked
};

/// How long a case runs and what it is watched by.
template <int dim>
struct Watch {
    double end;                      ///< s
    sph::GuardSettings<dim> guard{}; ///< looked at in every 10th step
    std::vector<Sign> signs{};       ///< names and bounds, in the order of the numbers that are measured
    int every = 10;                  ///< steps between two measurements
    double expected_steps = 0;       ///< at cfl = 1; twenty times as many and the steps have collapsed
};

/// Kinetic energy of all that moves, J, and with what is stored and the weight.
struct Energy {
    double kinetic = 0, all = 0;
};
template <class Scene>
Energy energy_of(const Scene& scene) {
    Energy sum;
    scene.engine().for_each_phase([&]<class P>(std::type_identity<P>, const auto&) {
        if constexpr (P::moves) {
            const auto phase = scene[sph::PhaseHandle<P>{}];
            const double kinetic = sph::kinetic_energy(phase);
            sum.kinetic += kinetic;
            sum.all += kinetic + sph::potential_energy(phase, scene.settings().gravity);
            using State = std::remove_cvref_t<decltype(phase.state)>;
            if (State::template stores<sph::AveragedMeanStress>) // its energy is that of averaged volumes
                sum.all = std::numeric_limits<double>::quiet_NaN();
            else if (scene.steps() > 0) // before, nothing is evaluated yet, and nothing stored
                sum.all += sph::stored_energy(phase);
        }
    });
    return sum;
}

/// The first words of a cause.
inline const char* name_of(sph::Cause cause) {
    switch (cause) {
    case sph::Cause::not_finite:
        return "not finite";
    case sph::Cause::too_fast:
        return "faster than sound";
    case sph::Cause::wrong_density:
        return "density";
    case sph::Cause::left_domain:
        return "left the domain";
    case sph::Cause::inside_wall:
        return "inside a wall";
    case sph::Cause::narrow_pore:
        return "narrow pore";
    case sph::Cause::energy:
        return "energy from nowhere";
    case sph::Cause::met:
        return "met without a coupling";
    }
    return "?";
}

/// Steps to the end of the watch. `measure` gives the numbers of the watch's signs.
template <class Scene, int dim, class Measure>
Outcome march(Scene& scene, const Plan& plan, const Watch<dim>& watch, const Measure& measure) {
    Outcome out;
    out.signs = watch.signs;
    std::map<std::string, long long> limited;
    double kinetic_most = 0, next_line = 0;
    const double most_steps = watch.expected_steps > 0 ? 20 * watch.expected_steps / plan.cfl : 1e5;
    Energy start, now;
    const auto look = [&] {
        now = energy_of(scene);
        kinetic_most = std::max(kinetic_most, now.kinetic);
        const std::vector<double> values = measure(scene);
        for (std::size_t k = 0; k < values.size(); ++k) {
            Sign& sign = out.signs[k];
            if (!(values[k] <= sign.worst)) // also where it is not a number
                sign.worst = values[k];
            if (!(values[k] <= sign.bound) && out.stable) {
                out.stable = false;
                out.cause = sign.name;
                out.message = sph::text(sign.name, " is ", values[k], ", its bound ", sign.bound, ", at step ",
                                        scene.steps(), ", time ", scene.time(), " s");
            }
        }
        if (plan.trace && (scene.time() >= next_line || !out.stable)) {
            std::printf("%8lld %11.4g s  kinetic %11.4g  all %14.6g J ", scene.steps(), scene.time(), now.kinetic,
                        now.all);
            for (std::size_t k = 0; k < values.size(); ++k)
                std::printf("  %s %.4g", out.signs[k].name.c_str(), values[k]);
            std::printf("\n");
            next_line += watch.end / 100;
        }
    };
    try {
        scene.prepare();
        start = energy_of(scene);
        look();
        sph::Guard<dim> guard(watch.guard);
        guard(scene);
        while (out.stable && scene.time() < watch.end) {
            const auto limits = scene.time_step_limits();
            double seconds = watch.end / 20; // of a scene that nothing limits
            if (!limits.empty() && limits.front().seconds < seconds) {
                seconds = limits.front().seconds;
                ++limited[limits.front().reason];
            }
            scene.step(plan.cfl * seconds);
            guard(scene);
            if (scene.steps() % watch.every == 0 || scene.time() >= watch.end)
                look();
            if (static_cast<double>(scene.steps()) > most_steps)
                throw sph::Error("steps collapsed");
        }
    } catch (const sph::Diverged& error) {
        out.stable = false;
        out.cause = name_of(error.cause);
        out.message = error.what();
    } catch (const sph::Error& error) {
        out.stable = false;
        out.message = error.what();
        out.cause = out.message.substr(0, out.message.find_first_of(";,(:"));
    }
    out.steps = scene.steps();
    out.energy_drift = (now.all - start.all) / kinetic_most;
    for (const auto& [reason, count] : limited)
        if (const double share = static_cast<double>(count) / static_cast<double>(out.steps); share > out.share) {
            out.limit = reason;
            out.share = share;
        }
    if (plan.trace)
        std::printf("%s%s\n", out.stable ? "stable" : "failed: ", out.message.c_str());
    return out;
}

} // namespace stability
