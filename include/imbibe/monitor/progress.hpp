// The live line of a run: progress, pace, what limits the step, time left.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/solver/solver.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>

namespace imbibe {

/// Seconds as "1:02:03" or "2:03".
inline std::string clock_text(double seconds) {
    const long long s = seconds > 0 && seconds < 1e9 ? static_cast<long long>(seconds + 0.5) : 0;
    char out[40];
    if (s >= 3600)
        std::snprintf(out, sizeof out, "%lld:%02lld:%02lld", s / 3600, s / 60 % 60, s % 60);
    else
        std::snprintf(out, sizeof out, "%lld:%02lld", s / 60, s % 60);
    return out;
}

/// An observer for `run_until` that keeps one line of output up to date.
class Progress {
public:
    /// @param end the time the run goes to, s
    /// @param live rewrite the line in place (a terminal), or print a new one now and then (a file)
    /// @throws Error for an end that is below 0 s or not a number
    Progress(double end, bool live) : end_(end), live_(live), started_(Clock::now()), shown_(started_) {
        require(end >= 0, "Progress(end, live): end = ", end,
                " s; it must be a number not below 0 s, the time that run_until is given");
    }

    /// Is called after every step.
    template <class Scene>
    void operator()(const Scene& scene) {
        note({scene.time(), scene.steps(), scene.particles(), scene.last_step()});
    }
    /// The text it prints: share, time, step, length of the step and what limits it, pace, wall time left. The step is
    /// the last one that the end of the run did not cut off, if there was one: a cut-off step says nothing.
    template <class Scene>
    std::string line(const Scene& scene) const {
        return line_of({scene.time(), scene.steps(), scene.particles(), scene.last_step()});
    }
    /// Wall time since the observer was made, s.
    double wall_seconds() const { return seconds(started_, Clock::now()); }

private:
    using Clock = std::chrono::steady_clock;
    struct Moment { // of the scene
        double time;
        long long steps, particles;
        const TimeStepLimit& last_step;
    };
    void note(const Moment& now);
    std::string line_of(const Moment& now) const;
    static bool cut_off(const TimeStepLimit& step) { return step.reason == "end of run"; }
    static double seconds(Clock::time_point a, Clock::time_point b) {
        return std::chrono::duration<double>(b - a).count();
    }
    double end_, begin_ = 0, work_ = 0;
    bool live_, first_ = true;
    Clock::time_point started_, shown_;
    TimeStepLimit whole_step_{0, "", ""}; ///< the last one that was not cut off by the end of the run
};

/// An observer that calls `what(scene)` at the first step at or after every multiple of `interval`, s, also where a run
/// continues from a checkpoint or time has gone back to one: at the same steps as in an uninterrupted run.
template <class F>
class Every {
public:
    /// @throws Error for an interval that is not above 0 s
    Every(double interval, F what) : interval_(interval), what_(std::move(what)) {
        require(std::isfinite(interval) && interval > 0, "every(interval, ...): interval = ", interval,
                " s; it must be a finite number above 0 s");
    }
    /// Is called after every step.
    template <class Scene>
    void operator()(Scene& scene) {
        if (!(scene.time() >= seen_)) { // the first call, or time has gone back
            next_ = 0;
            if (scene.steps() > 0)
                take_for_done(scene.time() - scene.last_step().seconds);
        }
        seen_ = scene.time();
        if (scene.time() < next_ * interval_ * (1 - 1e-9))
            return;
        what_(scene);
        take_for_done(scene.time());
    }
    /// Takes everything up to and including `time`, s, for done, whether it was or not.
    void resume(double time) {
        take_for_done(time);
        seen_ = time;
    }

private:
    void take_for_done(double time) {
        const double until = time * (1 + 1e-9);
        next_ = std::max(next_, std::floor(until / interval_));
        for (int k = 0; k < 2 && next_ * interval_ <= until; ++k) // the quotient may be rounded down
            ++next_;
    }

    double interval_;
    F what_;
    double next_ = 0;
    double seen_ = std::numeric_limits<double>::infinity(); ///< the time of the last call, s
};
/// Makes an `Every`, for `run_until`: `every(0.02, Snapshots("out"))`.
/// @throws Error for an interval that is not above 0 s
template <class F>
Every<F> every(double interval, F what) {
    return Every<F>(interval, std::move(what));
}

} // namespace imbibe

#if IMBIBE_READS_CODE
#include <imbibe/monitor/progress_code.hpp>
#endif
