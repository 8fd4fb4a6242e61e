// The engine of scenes in `dim` dimensions with numbers of type Real, and what looks at such scenes: explicit
// instantiations for the library imbibe::core.
#pragma once

#include <imbibe/monitor/guard.hpp>
#include <imbibe/output/snapshots.hpp>
#include <imbibe/solver/describe.hpp>
#include <imbibe/solver/population.hpp>
#include <imbibe/solver/scene_engine.hpp>
#include <imbibe/solver/scene_run.hpp>
#include <imbibe/solver/scene_watch.hpp>
#include <imbibe/solver/time_step_limits.hpp>
#include <imbibe/solver/warnings.hpp>

#define IMBIBE_ENGINE(dim, Real)                                                                                       \
    namespace imbibe::detail {                                                                                         \
    template class PhaseStore<dim, Real>;                                                                              \
    template class Seen<dim, Real>;                                                                                    \
    template class SceneStore<dim, Real>;                                                                              \
    template class Neighbourhood<dim, Real>;                                                                           \
    template class Mover<dim, Real>;                                                                                   \
    template class Threads<dim, Real>;                                                                                 \
    template class SceneEngine<dim, Real>;                                                                             \
    template double reduced(const PhaseStore<dim, Real>&, const Reduction<dim, Real>&, int);                           \
    template class PairDistances<dim, Real, native_width<Real>>;                                                       \
    template double box_of(const SceneStore<dim, Real>&, int);                                                         \
    template void require_support(const Neighbourhood<dim, Real>&, double, const std::string&);                        \
    template void require_supports_of_terms(const Neighbourhood<dim, Real>&);                                          \
    template std::vector<Point<dim>> places_of_new(const Neighbourhood<dim, Real>&, int,                               \
                                                   const std::vector<Point<dim>>&, double, double,                     \
                                                   const Origin<dim>&);                                                \
    template void add_particles(PhaseStore<dim, Real>&, const std::vector<Point<dim>>&, double, double);               \
    template std::vector<Handed> hand_over(PhaseStore<dim, Real>&, PhaseStore<dim, Real>&, const std::vector<char>&);  \
    template OutlineOfScene outline_of(const SceneStore<dim, Real>&, const Origin<dim>&);                              \
    template std::vector<PhasePair> pairs_of_phases(const SceneStore<dim, Real>&);                                     \
    template std::vector<TimeStepLimit> limits_of(const Neighbourhood<dim, Real>&, std::span<const LimitRow>, bool);   \
    template std::string describe_scene(const Neighbourhood<dim, Real>&, const Settings<dim>&, const TypesInWords&,    \
                                        const LimitsInWords&);                                                         \
    template void note_doubts_of_scene(Warnings&, const Neighbourhood<dim, Real>&, const Origin<dim>&,                 \
                                       const OutlineOfScene&);                                                         \
    template void SceneWatch::look_at_added(const Neighbourhood<dim, Real>&, const Origin<dim>&, double, Warnings&);   \
    template void SceneWatch::start_anew(const Neighbourhood<dim, Real>&, const Origin<dim>&, double, Warnings&);      \
    template void SceneWatch::look_after_step(const Neighbourhood<dim, Real>&, const Origin<dim>&, double, double,     \
                                              Warnings&);                                                              \
    }                                                                                                                  \
    template void imbibe::Guard<dim>::look_after_step(const imbibe::SceneRun<dim, Real>&);                             \
    template void imbibe::Guard<dim>::look_at_all(const imbibe::SceneRun<dim, Real>&);                                 \
    template class imbibe::SceneRun<dim, Real>;                                                                        \
    template void imbibe::Snapshots::write(const imbibe::detail::SceneStore<dim, Real>&, double,                       \
                                           const imbibe::detail::Origin<dim>&);
