// Makes the outline of a scene, and looks at it while the scene runs: for particles that were added over others, and
// for phases and bodies that meet though nothing acts between them.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/solver/meetings.hpp>
#include <imbibe/solver/neighbourhood.hpp>
#include <imbibe/solver/warnings.hpp>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace imbibe::detail {

/// Is a phase total-Lagrangian, and is it not looked for neighbours as they lie now within it?
bool knows_bodies(const SceneTable& table, int phase);
/// Does a coupling tie two phases together?
bool are_coupled(const SceneTable& table, int a, int b);

/// The outline of a scene, as it is now. @param origin of its coordinates, m
template <int dim, class Real>
OutlineOfScene outline_of(const SceneStore<dim, Real>& scene, const Origin<dim>& origin);

/// Each two phases of a scene once.
template <int dim, class Real>
std::vector<PhasePair> pairs_of_phases(const SceneStore<dim, Real>& scene);

class SceneWatch {
public:
    const std::vector<Meeting>& met() const { return met_; }

    /// After particles were added to a scene, and a search.
    template <int dim, class Real>
    void look_at_added(const Neighbourhood<dim, Real>& scene, const Origin<dim>& origin, double time,
                       Warnings& warnings);
    /// After the particles of a scene were replaced by those of a checkpoint.
    template <int dim, class Real>
    void start_anew(const Neighbourhood<dim, Real>& scene, const Origin<dim>& origin, double time, Warnings& warnings);
    /// After a step of `seconds`.
    template <int dim, class Real>
    void look_after_step(const Neighbourhood<dim, Real>& scene, const Origin<dim>& origin, double time, double seconds,
                         Warnings& warnings);

private:
    Meetings meetings_;
    std::vector<Meeting> met_;
    long long steps_ = 0;
    double since_look_ = 0; // s
    // By phase: how many of its particles, of all that were ever added, were looked for crowding, and was any found?
    std::vector<std::pair<long long, bool>> crowding_;

    static bool anyone_may_meet(const SceneTable& table);
    void note_meetings(const OutlineOfScene& outline, double time, Warnings& warnings);
    // Of all particles, m/s; infinite where a wall has no velocity, for a program may move it.
    template <int dim, class Real>
    static double greatest_speed(const Neighbourhood<dim, Real>& scene);
};

} // namespace imbibe::detail

#if IMBIBE_READS_CODE
#include <imbibe/solver/scene_watch_code.hpp>
#endif
