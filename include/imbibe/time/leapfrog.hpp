// Leapfrog in the form kick, drift, kick: positions and velocities of the same moment.
#pragma once

namespace imbibe {

/// v += dt/2 a(x), x += dt v, then states advance with the rates at the new positions, then v += dt/2 a(x).
///
/// The same trajectory as SymplecticEuler started half a step off, so as stable and as cheap, but velocities belong to
/// the time of the positions. It is of second order in dt for forces that depend on positions alone (a total-Lagrangian
/// solid), where SymplecticEuler is of first order. Not for second order with forces that depend on velocities
/// (viscosities), which use those of half a step before.
/// Source: Verlet (1967); Swope, Andersen, Berens and Wilson (1982); one evaluation of all terms a step.
struct Leapfrog {
    static constexpr bool allows_implicit = true; ///< all terms are evaluated once a step, and velocities follow
    template <class Engine>
    static void start(Engine& engine) {
        engine.template run<typename Engine::Composition::WholeStep>(0);
    }
    template <class Engine>
    static void step(Engine& engine, double dt) {
        engine.kick(dt / 2);
        engine.drift(dt);
        engine.find_neighbours();
        engine.template run<typename Engine::Composition::WholeStep>(dt);
        engine.kick(dt / 2);
    }
};

} // namespace imbibe
