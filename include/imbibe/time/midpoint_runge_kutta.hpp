// The explicit midpoint rule: Runge-Kutta of second order.
#pragma once

#include <imbibe/core/field.hpp>

namespace imbibe {

/// With y all integrated quantities (positions, velocities, states) and f their rates:
///   y' = y + dt/2 f(y),  y'' = y + dt f(y').
///
/// Of second order in dt for all forces, with two evaluations a step. Each evaluation has rates and forces at the same
/// time, so a fluid needs one sweep an evaluation where SymplecticEuler needs two. Not for undamped waves, which grow
/// by (c k dt)^4/8 a step: give the scene a viscosity or density diffusion, and a shorter step than SymplecticEuler's.
/// Neighbours are found once a step: pairs that come within reach during its first half are missed in the second, at
/// the rim, where compact kernels are near zero, and some are missed by one of the two particles only. Momentum is
/// conserved to 1e-7 of its amount in 200 steps of water, worse with a stiff KernelRepulsion, and to round-off with
/// Settings::search_interval above 1, whose lists have a skin. Terms that read the length of the step see 0:
/// HughesWingetStress is JaumannStress here.
///
/// Source: Runge (1895).
struct MidpointRungeKutta {
    /// The passes of a step, for reports.
    template <class Composition>
    using Passes = TypeList<typename Composition::Rates, typename Composition::Rates>;

    template <class Engine>
    static void step(Engine& engine, double dt) {
        using Rates = typename Engine::Composition::Rates;
        engine.find_neighbours();
        engine.remember();
        engine.template run<Rates>(0);
        engine.advance_remembered(dt / 2);
        engine.template run<Rates>(0);
        engine.advance_remembered(dt);
    }
};

} // namespace imbibe
