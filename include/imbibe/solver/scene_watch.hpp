// Makes the outline of a scene, and checks it while the scene runs: for added particles that overlap others, and for
// phases and bodies that meet although nothing acts between them.
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

/// Is a phase total-Lagrangian, without present neighbours within itself?
bool knows_bodies(const SceneTable& table, int phase);
/// Does a coupling tie two phases together?
bool are_coupled(const SceneTable& table, int a, int b);

/// The present outline of a scene. @param origin of its coordinates, m
template <int dim, class Real>
OutlineOfScene outline_of(const SceneStore<dim, Real>& scene, const Origin<dim>& origin);

/// Every pair of phases of a scene, once.
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
    // By phase: how many particles, of all ever added, were checked for crowding, and was any found?
    std::vector<std::pair<long long, bool>> crowding_;

    static bool anyone_may_meet(const SceneTable& table);
    void note_meetings(const OutlineOfScene& outline, double time, Warnings& warnings);
    // Of all particles, m/s; infinite if a wall has no velocity, because a program may move it.
    template <int dim, class Real>
    static double greatest_speed(const Neighbourhood<dim, Real>& scene);
};

} // namespace imbibe::detail

#if IMBIBE_READS_CODE
#include <imbibe/solver/scene_watch_code.hpp>
#endif
