// What the programs of this folder have in common: their arguments, the clock of a run, and the report of it, which
// tools/compare_peers.py reads.
#pragma once

#include "../../examples/support/arguments.hpp"
#include "../support/working.hpp"

#include <imbibe/core/error.hpp>
#include <imbibe/core/fields.hpp>
#include <imbibe/version.hpp>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <initializer_list>
#include <string>
#include <sys/resource.h>
#include <type_traits>

namespace imbibe::peers {

/// Runs one scene: `program float|double [threads] [spacing in mm]`. `run.template operator()<Real>(threads, spacing)`
/// runs it with a spacing in m. Returns the exit status.
template <class Run>
int main_of(int argc, char** argv, double spacing_mm, double finest_mm, const Run& run) {
    try {
        const std::string precision = argc > 1 ? argv[1] : "";
        require(precision == "float" || precision == "double", "the precision, '", precision,
                "', must be float or double; give it first, then the threads and the spacing in mm");
        const int threads = static_cast<int>(example::number(argv, 2, "the number of threads", 1, 1, 1024));
        const double spacing =
            1e-3 * example::number(argv, 3, "the spacing in mm", spacing_mm, finest_mm, 4 * spacing_mm);
        if (precision == "float")
            run.template operator()<float>(threads, spacing);
        else
            run.template operator()<double>(threads, spacing);
        return 0;
    } catch (const Error& error) {
        std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
        return 2;
    }
}

/// The clock of a run and what it counts. Begins when it is made; what a scene needs before its first step, a search
/// among the rest, is measured with it.
template <class Scene>
class Meter {
public:
    Meter() : wall_(Clock::now()), cpu_(cpu_seconds()) {}

    /// To be called after every step. The particles that have work are counted in one step of 64.
    void operator()(const Scene& scene) {
        const bool counted = steps_ % 64 == 0;
        double moving = 0, working = 0;
        scene.engine().for_each_phase([&]<class P>(std::type_identity<P>, const auto& phase) {
            moving += P::moves ? phase.size() : 0;
            if (counted)
                working += bench::working<P>(scene.engine(), phase.size());
        });
        working_ = counted ? working : working_;
        moving_steps_ += moving;
        working_steps_ += working_;
        all_steps_ += static_cast<double>(scene.particles());
        ++steps_;
    }

    /// Ends the clock and prints the report as JSON. Throws Error for a scene that has blown up, or that took no step.
    /// @param measured what the scene is judged by, in the order of tools/compare_peers.py
    template <class Real>
    void print(const char* name, const Scene& scene, Real, double spacing, std::initializer_list<double> measured) {
        const double wall = std::chrono::duration<double>(Clock::now() - wall_).count(), cpu = cpu_seconds() - cpu_;
        scene.engine().for_each_phase([&]<class P>(std::type_identity<P>, const auto& phase) {
            if constexpr (P::moves)
                require(static_cast<double>(phase.view(velocity).cwiseAbs().maxCoeff()) < phase.material.sound_speed,
                        "the scene has blown up: its time is not that of a run");
        });
        require(steps_ > 0, "the scene took no step");
        rusage used{};
        getrusage(RUSAGE_SELF, &used);
        const auto n = static_cast<double>(steps_);
        std::printf("{\"scene\": \"%s\", \"code\": \"imbibe\", \"version\": \"%d.%d.%d\", \"precision\": \"%s\",\n",
                    name, IMBIBE_VERSION_MAJOR, IMBIBE_VERSION_MINOR, IMBIBE_VERSION_PATCH,
                    sizeof(Real) == 4 ? "float" : "double");
        std::printf(" \"threads\": %d, \"spacing\": %.6g, \"moving\": %.1f, \"working\": %.1f, \"all\": %.1f,\n",
                    scene.threads(), spacing, moving_steps_ / n, working_steps_ / n, all_steps_ / n);
        std::printf(
            " \"neighbours\": %.1f, \"steps\": %lld, \"simulated_s\": %.9g, \"wall_s\": %.4f, \"cpu_s\": %.4f,\n",
            bench::neighbours_in(scene.engine()), steps_, scene.time(), wall, cpu);
        std::printf(" \"peak_bytes\": %lld, \"measured\": [", 1024LL * used.ru_maxrss);
        const char* between = "";
        for (const double value : measured) {
            std::printf("%s%.6g", between, value);
            between = ", ";
        }
        std::printf("]}\n");
    }

private:
    using Clock = std::chrono::steady_clock;
    /// Of all threads.
    static double cpu_seconds() {
        rusage used{};
        getrusage(RUSAGE_SELF, &used);
        const auto seconds = [](const timeval& t) {
            return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
        };
        return seconds(used.ru_utime) + seconds(used.ru_stime);
    }

    Clock::time_point wall_;
    double cpu_, working_ = 0, moving_steps_ = 0, working_steps_ = 0, all_steps_ = 0;
    long long steps_ = 0;
};

} // namespace imbibe::peers
