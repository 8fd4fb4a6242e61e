// Runs the passes of a scene: clears sums, brings up to date what others see, and has the loops run. It knows no type
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

    /// Who runs the loops; copies of the scene share it.
    std::shared_ptr<const Space<dim, Real>> space = std::make_shared<Threads<dim, Real>>();
    /// By how much states are advanced by the pass that is run, s.
    double step_length = 0;
    /// When the step begins, s.
    double time = 0;

    /// Evaluates terms of the phases that are chosen, in the order of their plan. `dt` is by how much states are
    /// advanced, s.
    void run(const Pass<dim, Real>& pass, double dt, const Bits& chosen = Base::all_phases);
    /// The same for phases that have grown, and those that sum over such: for what is computed once.
    void run_for_grown(const Pass<dim, Real>& pass);

private:
    // Sums start from zero, the acceleration from gravity.
    void clear(const ColumnRange& range);
    void run(const Loop<dim, Real>& loop);
    // Adds an ImplicitAcceleration, if that is what stands in the columns, to the acceleration.
    void add_if_implicit(const ColumnRange& range);
    bool meets_any(const Loop<dim, Real>& loop) const {
        return std::any_of(loop.links.begin(), loop.links.end(),
                           [&](int k) { return !this->link_at(k).runs.is_empty(); });
    }
    // What others see of a total-Lagrangian phase is brought up to date, as far as it is read.
    void fetch(const Link& link, const Bits& reads);
};

} // namespace imbibe::detail

#if IMBIBE_READS_CODE
#include <imbibe/solver/scene_engine_code.hpp>
#endif
