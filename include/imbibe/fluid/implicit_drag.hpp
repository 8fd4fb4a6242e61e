// Drags between particles of any stiffness: equal and opposite, without a limit on the time step.
#pragma once

#include <imbibe/core/term.hpp>

#include <type_traits>

namespace imbibe::detail {

// The velocity at the end of the step without implicit accelerations, m/s.
IMBIBE_INLINE constexpr auto expected_velocity(const auto& a, double time_step) {
    if constexpr (std::remove_cvref_t<decltype(a)>::Material::moves)
        return a[velocity] + (time_step * a[mobility]) * a[acceleration];
    else
        return a[velocity];
}

// The drag_rate of a particle that the drag moves, 1/s; 0 for a wall and for held particles.
IMBIBE_INLINE constexpr auto yielding_rate(const auto& a) {
    if constexpr (std::remove_cvref_t<decltype(a)>::Material::moves)
        return a[mobility] * a[drag_rate];
    else
        return 0.0;
}

// Is this a step? An integrator that needs accelerations before its first step asks for them with a step of 0, in which
// a stiff drag would be explicit.
constexpr double in_a_step(double time_step) {
    return time_step > 0 ? 1 : 0;
}

/// The two parts of an implicit drag between particles a and b with the coefficient K_ab >= 0, kg/s, that `Law` has:
/// Rate adds sum_b K_ab/m_a to the drag_rate L_a, and Slow
///
///     - 1/m_a sum_b K_ab/(1 + dt (L_a + L_b)) (v*_a - v*_b),    v* = v + dt dv/dt,
///
/// to the implicit acceleration, in m/s^2, with the acceleration dv/dt by all other terms. Where the velocities and K
/// are the same all over each of two phases that is the backward Euler step of their difference. Equal and opposite:
/// momentum is conserved. No wave of the velocities grows, however large K is: twice the sum of the weights of a
/// particle is below 2/dt, which bounds all eigenvalues (Gershgorin). A pass without a step, dt = 0, has no drag.
///
/// A wall or a held particle keeps its velocity: L_b = 0.
///
/// `Law` has `Reads`, `Numbers` with the members of a part that hold its `parameters` and what it prepares, and
/// `coefficient(numbers, a, b, ab)`: symmetric, 0 for the particle itself.
template <class Law>
struct ImplicitDrag {
    struct Rate : Law::Numbers {
        using reads = Concat<Fields<mass>, typename Law::Reads>;
        using adds = Fields<drag_rate>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            return Law::coefficient(*this, a, b, ab) / a[mass];
        }
    };
    struct Slow : Law::Numbers {
        using reads = Concat<Fields<mass, velocity, acceleration, mobility, drag_rate>, typename Law::Reads>;
        using adds = Fields<implicit_acceleration>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            using T = typename std::remove_cvref_t<decltype(a)>::Scalar;
            const T dt(a.time_step);
            const auto rates = yielding_rate(a) + yielding_rate(b);
            const T weight =
                in_a_step(a.time_step) * Law::coefficient(*this, a, b, ab) / (a[mass] * (1 + dt * rates));
            return weight * (expected_velocity(b, a.time_step) - expected_velocity(a, a.time_step));
        }
    };
};

} // namespace imbibe::detail
