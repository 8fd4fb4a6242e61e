// Position Verlet: drift, kick, drift.
#pragma once

namespace imbibe {

/// x += dt/2 v, forces there, v += dt a, x += dt/2 v. States (densities, stresses) advance once a step, with the rates
/// at the middle.
///
/// As stable and as cheap as SymplecticEuler, and of second order in dt for forces that depend on positions alone.
/// Neighbours are those of the middle of the step. HughesWingetStress<AfterTheMove> suits it: all motion between two
/// evaluations has the same velocities. A checkpoint sorts the particles at the end of a step, so the bits of a run
/// depend on when checkpoints are written; a restarted run has the bits of the run that wrote the checkpoint.
///
/// Not where output densities and pressures must belong to the output positions: states belong to the middle of the
/// step, where the forces are evaluated.
///
/// Source: Tuckerman, Berne and Martyna (1992); one evaluation of all terms a step.
struct PositionVerlet {
    static constexpr bool allows_implicit = true; ///< all terms are evaluated once a step, and velocities follow
    template <class Engine>
    static void step(Engine& engine, double dt) {
        engine.drift(dt / 2);
        engine.find_neighbours();
        engine.template run<typename Engine::Composition::WholeStep>(dt);
        engine.kick(dt);
        engine.drift(dt / 2);
    }
};

} // namespace imbibe
