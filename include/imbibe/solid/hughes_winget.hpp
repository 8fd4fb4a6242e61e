// Hooke's law for the deviatoric stress as a rate, with the rotation of the step applied exactly.
#pragma once

#include <imbibe/core/term.hpp>
#include <imbibe/solid/shear_energy.hpp>

namespace imbibe {

/// The velocity gradient is taken at the end of the motion with these velocities: SymplecticEuler, Leapfrog and
/// PositionVerlet. (PositionVerlet evaluates forces half way of a step, but the velocities of the step before have
/// moved the particles there since the last evaluation.)
struct AfterTheMove {
    static constexpr double back = 0.5; ///< how many steps the middle of the motion lies back
};
/// The velocity gradient is taken in the middle of the motion with these velocities: StaggeredLeapfrog.
struct HalfWay {
    static constexpr double back = 0; ///< it does not
};

/// S' = Q S Q^T + 2 G dt (e - tr(e)/3 1), in Pa, for a step of dt: an orthogonal Q rotates the stress, then Hooke's law
/// is added. As a rate, in Pa/s:
///
///     dS/dt = R S + S R^T + dt R S R^T + 2 G (e - tr(e)/3 1),   R = (1 - dt/2 Omega)^-1 Omega,   Q = 1 + dt R,
///
/// with e and Omega the symmetric and antisymmetric parts of the velocity gradient with respect to the middle of the
/// motion, L (1 - dt/2 L)^-1 for a gradient L taken after the move (`When`). A rigid rotation then gives e = 0 and for
/// Q the rotation itself, however long the step. For dt -> 0 this is JaumannStress.
///
/// For updated-Lagrangian solids with large rotations. A thousand turns of a prescribed rotation, 100 steps each,
/// change the stress by 3e-11 of itself; JaumannStress with the same steps is off by more than the stress after one
/// turn. In two dimensions plane strain, as there.
///
/// Not for Poisson's ratios near 0.5, where the mean stress alternates from particle to particle (the bound of 0.495 is
/// that of CompressibleNeoHookean).
///
/// Not a cure for the errors of the Jaumann rate in large shear (S_xy = G sin(shear)), nor for a velocity gradient that
/// is too small, as that of VelocityGradient at a free surface: there the stress turns slower than the material. Exact
/// for steps of constant length only: L belongs to the last step, dt to this one. With the wrong `When` the stress lags
/// behind the material, by 0.39 rad in 100 turns of 126 steps each, and by a quarter of that with steps half as long.
/// Not with MidpointRungeKutta and PredictorCorrector, whose rates are not those of a step (dt = 0): there it is
/// JaumannStress.
///
/// Source: Hughes and Winget (1980). The density keeps the rate of its own equation.
template <class When = AfterTheMove>
struct HughesWingetStress {
    using effect = effects::stress_rate;
    static constexpr bool of_solids = true;
    static constexpr double greatest_poisson_ratio = 0.495;
    using reads = Fields<velocity_gradient, deviatoric_stress>;
    using adds = Fields<deviatoric_stress_rate>;
    using reductions = Parts<ShearEnergy>;
    static constexpr bool in_packs = true;

    IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
        using A = std::remove_cvref_t<decltype(a)>;
        using T = typename A::Scalar;
        constexpr int dim = A::dimension;
        const auto one = identity<T, dim>();
        const auto unit = symmetric_identity<T, dim>();
        const T dt = T(a.time_step);
        const auto L = a[velocity_gradient];
        const auto middle = L * inverse(one - T(When::back) * dt * L);
        const auto e = symmetric_part(middle);
        const auto Omega = antisymmetric_part(middle);
        const auto R = inverse(one - T(0.5) * dt * Omega) * Omega;
        const auto S = full(a[deviatoric_stress]);
        const auto RS = R * S;
        return 2 * a.material.shear_modulus * (e - trace(e) / 3 * unit) +
               symmetric_part(T(2) * RS + dt * RS * transpose(R));
    }
};

} // namespace imbibe
