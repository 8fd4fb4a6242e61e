// Dual time stepping: some terms are evaluated once in a long step, all others in each of the short ones it is made of.
#pragma once

#include <imbibe/core/field.hpp>

namespace imbibe {

/// SymplecticEuler in short steps, as long as sound and what else is stiff allow, within a long one, as long as it
/// takes a particle to move by a part of its spacing. In the long step neighbours are found and the terms named here
/// are evaluated, with the states as they are; what they add to accelerations, and transport corrections that they set,
/// are the same in all of its short steps:
///   a_slow = a_slow(x, rho, v);  then, n times,
///   rho' = rho + dt/n D(x, v),  v' = v + dt/n (a(x, rho') + a_slow),  x' = x + dt/n v'.
///
/// A long step is `cfl` times the least of: the limits of the slow terms themselves, and spacing/max(|v|, sqrt(spacing
/// |a|)), "advection", of each phase that moves. With a sound speed of ten times the flow's that is some ten short
/// steps. `Settings::search_skin` keeps pairs from being missed that come within reach during a long step; without it
/// neighbours stay as they were at its start, as in the source, and momentum is conserved but for what pairs at the rim
/// of their support weigh.
///
/// For terms that change as slowly as the flow and cost sums of their own: viscosities, ParticleShifting, corrected
/// gradients (`CurrentCorrection`). A function of one particle that fast terms ask for too (Volume, an equation of
/// state) is evaluated with them, and so is what adds to a sum that they ask for. In a coupling name its terms as well:
/// NoSlipViscosity, ShiftingNeighbours.
///
/// Not for terms that change densities or stresses (SlowTermOfState, a compile error), nor for pressures and
/// repulsions, nor for a viscosity so high that its own limit is shorter than the sound's: then there is one short step
/// in each. Not where all is shaken within a long step, as in a splash. For a stiff solid in soft company: Subcycled.
///
/// Source: Zhang, Rezavand and Hu (2020), dual-criteria time stepping, with the advection criterion of one spacing
/// instead of a smoothing length; forces that are held over several steps, Tuckerman, Berne and Martyna (1992).
/// @tparam SlowTerm terms of the scene's phases and couplings
template <class... SlowTerm>
struct DualStepping {
    /// The terms that are evaluated in long steps.
    using Slow = TypeList<SlowTerm...>;
    /// What is evaluated in a step, for reports: the slow terms in a long one, all others in each short one.
    template <class Composition>
    using Passes =
        TypeList<typename Composition::template TermsOf<Slow>, typename Composition::template AllButTermsOf<Slow>>;
    /// Is the limit that `Term` of a phase or coupling sets one on the short steps?
    template <class Where, class Term>
    static constexpr bool in_substeps = !detail::contains<Term, Slow>;
    /// Particles keep their neighbours during a long step, so their way in it is limited.
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
