// The code of scene_run.hpp.
#pragma once

#include <imbibe/solver/scene_run.hpp>

#include <algorithm>

namespace imbibe {

template <int dim, class Real>
SceneRun<dim, Real>::SceneRun(const Settings<dim>& with, bool subcycles)
    : settings_(with), warnings_(with.on_warning), given_{with.cfl, with.time_step, with.max_time_step},
      subcycles_(subcycles) {
    with.check();
}

template <int dim, class Real>
void SceneRun<dim, Real>::set_up(BaseEngine& engine) const {
    const Settings<dim>& with = settings_;
    search::Periodic<dim> sides;
    for (std::size_t d = 0; d < dim; ++d) {
        engine.gravity[static_cast<int>(d)] = with.gravity[d];
        sides.lower[d] = with.periodic_lower[d] - with.origin[d];
        sides.length[d] = with.periodic_length[d];
    }
    engine.search_interval = std::min(with.search_interval, 1 << 30); // it is added to
    engine.search_skin = with.search_interval > 1 || subcycles_ ? with.search_skin : 0;
    engine.threads = with.threads > 0 ? with.threads : available_threads();
    engine.set_periodic(sides);
}

template <int dim, class Real>
long long SceneRun<dim, Real>::particles() const {
    long long n = 0;
    for (const auto& s : base_engine().phases)
        n += s.size();
    return n;
}

template <int dim, class Real>
void SceneRun<dim, Real>::set_gravity(const std::array<double, static_cast<std::size_t>(dim)>& gravity) {
    Settings<dim> changed = settings_;
    changed.gravity = gravity;
    changed.check();
    settings_ = changed;
    for (std::size_t d = 0; d < dim; ++d)
        base_engine().gravity[static_cast<int>(d)] = gravity[d];
}

template <int dim, class Real>
TimeStepLimit SceneRun<dim, Real>::next_step() const {
    if (settings_.time_step > 0)
        return {settings_.time_step, "fixed", "settings"};
    const auto limits = time_step_limits();
    if (!limits.empty() && limits.front().seconds == 0)
        throw Error(text("the limit on the time step by ", limits.front().reason, " (", limits.front().where,
                         ") is 0 s: a speed, an acceleration or a coefficient is infinite"));
    TimeStepLimit least{settings_.max_time_step, "max_time_step", "settings"};
    if (!limits.empty() && settings_.cfl * limits.front().seconds < least.seconds) {
        least = limits.front();
        least.seconds *= settings_.cfl;
    }
    return least;
}

template <int dim, class Real>
void SceneRun<dim, Real>::shorten_steps(double share) {
    require(share > 0 && share <= 1, "shorten_steps(", share, "); the share must be above 0 and at most 1");
    scale_steps(shortened_ * share);
}

template <int dim, class Real>
void SceneRun<dim, Real>::prepare() {
    const bool changed = may_have_changed_;
    if (changed) {
        check_numbers();
        prepare_terms();
    }
    may_have_changed_ = false;
    auto& engine = base_engine();
    engine.time = time_;
    if (prepared_ && steps_ > 0) {
        if (changed)
            engine.notice_greater_speeds();
        return;
    }
    const bool anew = !prepared_ || changed;
    if (anew) {
        require(particles() > 0, "the scene has no particles; add some before the first step");
        for (auto& s : engine.phases) // before the first step coefficients may have changed, too
            s.grown = s.grown || steps_ == 0;
        engine.find_reference_neighbours();
    }
    engine.search_neighbours();
    // Later particles were checked when added, or motion has brought the two together.
    if (anew && steps_ == 0)
        detail::note_doubts_of_scene(warnings_, engine, settings_.origin, outline());
    if (!prepared_)
        watch_.look_at_added(engine, settings_.origin, time_, warnings_);
    if (anew)
        evaluate_once();
    start_steps();
    engine.measure_motion();
    prepared_ = true;
    if (settings_.time_step > 0 && steps_ == 0)
        if (const auto limits = time_step_limits();
            !limits.empty() && limits.front().seconds < settings_.time_step * (1 - 1e-9))
            warnings_.note(text("the fixed time step of ", settings_.time_step,
                                " s is longer than the longest stable one, ", limits.front().seconds, " s by ",
                                limits.front().reason, " (", limits.front().where,
                                "); with time_step = 0 steps adapt to the limits"));
}

template <int dim, class Real>
double SceneRun<dim, Real>::step() {
    prepare();
    const TimeStepLimit chosen = next_step();
    take(chosen);
    return chosen.seconds;
}

template <int dim, class Real>
void SceneRun<dim, Real>::step(double seconds) {
    require(std::isfinite(seconds) && seconds > 0, "a time step of ", seconds, " s; it must be above 0 s");
    prepare();
    take({seconds, "given", "caller"});
}

template <int dim, class Real>
void SceneRun<dim, Real>::take(const TimeStepLimit& chosen) {
    last_step_ = chosen;
    try {
        if (subcycles_) {
            const TimeStepLimit limit = shortest(detail::limits_of(base_engine(), limit_rows(), true));
            const double within = settings_.cfl * limit.seconds;
            const double count = std::ceil(chosen.seconds / within * (1 - 1e-9));
            require(count < 1e6, "a step of ", chosen.seconds, " s asks for ", count, " steps of ", within, " s (",
                    limit.reason, ", ", limit.where, "); at most a million are taken");
            substeps_ = std::max(1, static_cast<int>(count));
        }
        base_engine().time = time_;
        advance(chosen.seconds, substeps_);
    } catch (const Error& error) {
        const auto limits = time_step_limits();
        const std::string shortest_limit = limits.empty() ? "none"
                                                          : text(limits.front().seconds, " s (", limits.front().reason,
                                                                 ", ", limits.front().where, ")");
        throw Error(text(error.what(), "; step ", steps_, ", time ", time_, " s, time step ", chosen.seconds,
                         " s limited by ", chosen.reason, " (", chosen.where, "). The shortest limit is ",
                         shortest_limit, "; a step well below it is the first remedy to try"));
    }
    time_ += chosen.seconds;
    ++steps_;
    watch_.look_after_step(base_engine(), settings_.origin, time_, chosen.seconds, warnings_);
}

template <int dim, class Real>
void SceneRun<dim, Real>::require_finite(const std::string& words) const {
    for (const auto& s : base_engine().phases)
        if (s.size() > 0)
            require(search::bounds_of(s.points(), threads()).not_finite < 0, words,
                    "a coordinate of a particle of phase ", s.name, " is not a finite number");
}

} // namespace imbibe
