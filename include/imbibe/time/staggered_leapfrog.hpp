// Leapfrog with velocities half a step from positions and states: every rate is evaluated in the middle of its step.
#pragma once

#include <imbibe/core/field.hpp>

namespace imbibe {

/// With states s (densities, stresses) and their rates D:
///   v += dt a(x, s),  x += dt/2 v,  s += dt D(x, v),  x += dt/2 v.
///
/// Velocities belong to half steps, positions and states to whole ones, and D is evaluated with the particles halfway.
/// As stable for sound as SymplecticEuler, and as cheap wherever rates and forces are separate sweeps anyway.
///
/// For all phases whose density follows a continuity equation. Two particles that meet and part again have the same
/// density as before, to O(dt^2). With D at one end of the move (SymplecticEuler, Leapfrog, PositionVerlet) they keep
/// an excess of the order of dt in every encounter, and its pressure turns into speed: with the paper's kernel and step
/// a pair of water particles leaves over 2 % faster than it came (tests/solver/test_integrators.cpp), and the block of
/// water falls apart at 70 ms.
///
/// Initial velocities are taken for those of half a step before, an error of the order of dt. Velocity-dependent parts
/// of a (viscosity) use the velocity of half a step before. Neighbours are found once a step: pairs that come within
/// reach during its first half are missed for D, at the rim, where compact kernels are near zero.
///
/// Not in place of Subcycled where a stiff solid sets the step. A phase without rates of states (total Lagrangian)
/// moves as with SymplecticEuler. States see the velocities in the middle of the motion: HughesWingetStress<HalfWay>.
///
/// Source: the leapfrog of Hockney (1970) and of finite-difference codes on staggered grids; for its reversibility in
/// SPH see Zhang, Rezavand and Hu (2020), whose position Verlet halves the density's step as well.
struct StaggeredLeapfrog {
    static constexpr bool allows_implicit = true; ///< all terms are evaluated once a step, and velocities follow
    /// The passes of a step, for reports.
    template <class Composition>
    using Passes = TypeList<typename Composition::Forces, typename Composition::States>;

    template <class Engine>
    static void step(Engine& engine, double dt) {
        engine.find_neighbours();
        engine.template run<typename Engine::Composition::Forces>(dt);
        engine.kick(dt);
        engine.drift(dt / 2);
        engine.refresh_places();
        engine.template run<typename Engine::Composition::States>(dt);
        engine.drift(dt / 2);
    }
};

} // namespace imbibe
