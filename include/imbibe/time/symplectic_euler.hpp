// Symplectic Euler: states first, then velocities, then positions.
#pragma once

namespace imbibe {

/// Advances densities, stresses and other states with rates of the old velocities and positions, computes forces from
/// the new states, then v += dt a and x += dt v with the new velocities:
///   rho' = rho + dt D(x, v),  v' = v + dt a(x, rho'),  x' = x + dt v'.
/// For the acoustic oscillator this is the staggered leapfrog: it conserves energy on average and is stable to
/// c k dt < 2. With old rates everywhere (explicit Euler) even a dry sponge at rest blows up.
/// Not where velocities must belong to the time of the positions, as for the energy of an undamped solid: Leapfrog. Not
/// for vortices of low viscosity: their densities lag half a step behind the positions, and the pressure turns with
/// them. With steps of the default length a Taylor-Green vortex at Re = 1000 gains 3 % of energy until t = 1 over one
/// with steps of a quarter, with StaggeredLeapfrog nothing (tests/validation/test_fluid_schemes.cpp).
///
/// Source: Hairer, Lubich and Wanner (2003), Eq. 1.9; one evaluation of all terms a step.
struct SymplecticEuler {
    static constexpr bool allows_implicit = true; ///< all terms are evaluated once a step, and velocities follow
    template <class Engine>
    static void step(Engine& engine, double dt) {
        engine.find_neighbours();
        engine.template run<typename Engine::Composition::WholeStep>(dt);
        engine.kick(dt);
        engine.drift(dt);
    }
};

} // namespace imbibe
