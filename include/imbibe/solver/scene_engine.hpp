// Runs the passes of a scene: clears sums, updates the copies that others see, and launches the loops. It knows no type
// of the scene, only its tables.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/solver/closed_fluid.hpp>
#include <imbibe/solver/motion.hpp>
#include <imbibe/solver/space.hpp>
#include <imbibe/solver/tables.hpp>

#include <memory>

namespace imbibe::detail {

template <int dim, class Real>
class IMBIBE_PER_BUILD SceneEngine : public Mover<dim, Real> {
    using Base = Mover<dim, Real>;

public:
    using Phase = typename Base::Phase;
    using Base::Base;

    /// The space that runs the loops; copies of the scene share it.
    std::shared_ptr<const Space<dim, Real>> space = std::make_shared<Threads<dim, Real>>();
    /// The time by which the present pass advances states, s.
    double step_length = 0;
    /// The time at the begin of the step, s.
    double time = 0;

    /// Evaluates terms of the chosen phases, in the order of their plan. `dt` is the time by which states are advanced,
    /// s.
    void run(const Pass<dim, Real>& pass, double dt, const Bits& chosen = Base::all_phases);
    /// The same for phases that have grown, and those that sum over them: for what is computed once.
    void run_for_grown(const Pass<dim, Real>& pass);

private:
    // Sums start from zero, the acceleration from gravity.
    void clear(const ColumnRange& range);
    void run(const Loop<dim, Real>& loop);
    // Adds an ImplicitAcceleration, if the columns hold one, to the acceleration.
    void add_if_implicit(const ColumnRange& range);
    bool meets_any(const Loop<dim, Real>& loop) const {
        return std::any_of(loop.links.begin(), loop.links.end(),
                           [&](int k) { return !this->link_at(k).runs.is_empty(); });
    }
    // Updates the copy of a total-Lagrangian phase that others see, as far as it is read.
    void fetch(const Link& link, const Bits& reads);
};

} // namespace imbibe::detail

#if IMBIBE_READS_CODE
#include <imbibe/solver/scene_engine_code.hpp>
#endif
