// Dual time stepping: some terms are evaluated once in a long step, all others in each of its short steps.
#pragma once

#include <imbibe/core/field.hpp>

namespace imbibe {

/// SymplecticEuler in short steps, limited by sound and other stiff terms, within a long step, limited by the time in
/// which a particle moves a part of its spacing. In the long step neighbours are found and the terms named here are
/// evaluated, with the states at its start. What they add to accelerations, and the transport corrections they set, are
/// the same in all of its short steps:
///   a_slow = a_slow(x, rho, v);  then, n times,
///   rho' = rho + dt/n D(x, v),  v' = v + dt/n (a(x, rho') + a_slow),  x' = x + dt/n v'.
///
/// A long step is `cfl` times the least of the limits of the slow terms themselves and, for each phase that moves,
/// spacing/max(|v|, sqrt(spacing |a|)), "advection". With a sound speed of ten times the flow's that is some ten short
/// steps. With `Settings::search_skin` no pair is missed that comes within reach during a long step. Without it the
/// neighbour lists stay those of its start, as in the source, and momentum is conserved except for the small
/// contributions of pairs at the rim of the support.
///
/// For terms that change as slowly as the flow and need sums of their own: viscosities, ParticleShifting, corrected
/// gradients (`CurrentCorrection`). A function of one particle that fast terms need too (Volume, an equation of state)
/// is evaluated with the fast terms, and so is what adds to a sum that they need. In a coupling name its terms as well:
/// NoSlipViscosity, ShiftingNeighbours.
///
/// Not for terms that change densities or stresses (SlowTermOfState, a compile error), nor for pressures and
/// repulsions, nor for a viscosity so high that its own limit is shorter than that of sound: each long step then has
/// one short step. Not where the whole flow changes within a long step, as in a splash. For a stiff solid beside soft
/// phases: Subcycled.
///
/// Source: Zhang, Rezavand and Hu (2020), dual-criteria time stepping, with an advection criterion of one spacing
/// instead of a smoothing length; forces held over several steps: Tuckerman, Berne and Martyna (1992).
/// @tparam SlowTerm terms of the scene's phases and couplings
template <class... SlowTerm>
struct DualStepping {
    /// The terms that are evaluated in long steps.
    using Slow = TypeList<SlowTerm...>;
    /// The passes of a step, for reports: the slow terms in a long one, all others in each short one.
    template <class Composition>
    using Passes =
        TypeList<typename Composition::template TermsOf<Slow>, typename Composition::template AllButTermsOf<Slow>>;
    /// Is the limit of `Term` of a phase or coupling one on the short steps?
    template <class Where, class Term>
    static constexpr bool in_substeps = !detail::contains<Term, Slow>;
    /// Particles keep their neighbours during a long step, so their displacement in it is limited.
    static constexpr bool limits_advection = true;

    /// One long step.
    /// @param engine holds the particles
    /// @param dt its length, s
    /// @param substeps how many short steps it is made of
    template <class Engine>
    static void step(Engine& engine, double dt, int substeps) {
        using Composition = typename Engine::Composition;
        using Fast = typename Composition::template AllButTermsOf<Slow>;
        engine.find_neighbours();
        engine.template run<typename Composition::template TermsOf<Slow>>(dt);
        engine.template keep_sums<Fast>();
        for (int k = 0; k < substeps; ++k) {
            if (k > 0) {
                engine.refresh_places();
                engine.template restore_sums<Fast>();
            }
            engine.template run<Fast>(dt / substeps);
            engine.kick(dt / substeps);
            engine.drift(dt / substeps);
        }
    }
};

} // namespace imbibe
