// Predictor and corrector around the middle of the step, with one evaluation.
#pragma once

#include <imbibe/core/field.hpp>

namespace imbibe {

/// With y all integrated quantities and f the rates of the last evaluation:
///   predictor y' = y + dt/2 f,  then f = f(y'),  corrector y = y + dt f.
///
/// The cheapest step: one evaluation, with rates and forces at the same time, in one sweep where the terms allow it. Of
/// second order in dt. Not for undamped waves, which grow slowly, nor for long steps: give the scene a viscosity or
/// density diffusion, and a shorter step than SymplecticEuler's. Neighbours are found before the half step:
/// MidpointRungeKutta says what that does to momentum.
///
/// Source: Monaghan (1994), "Simulating free surface flows with SPH".
struct PredictorCorrector {
    /// The passes of a step, for reports.
    template <class Composition>
    using Passes = TypeList<typename Composition::Rates>;

    template <class Engine>
    static void start(Engine& engine) {
        engine.template run<typename Engine::Composition::Rates>(0);
    }
    template <class Engine>
    static void step(Engine& engine, double dt) {
        engine.find_neighbours();
        engine.remember();
        engine.advance_remembered(dt / 2);
        engine.template run<typename Engine::Composition::Rates>(0);
        engine.advance_remembered(dt);
    }
};

} // namespace imbibe
