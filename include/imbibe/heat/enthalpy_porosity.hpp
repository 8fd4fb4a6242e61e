// A Darcy drag that stops frozen fluid in a mould or skeleton at rest.
#pragma once

#include <imbibe/fluid/implicit_drag.hpp>
#include <imbibe/heat/frozen_drag.hpp>

namespace imbibe {

/// dv_a/dt = - L_a v*_a/(1 + dt D_a), L_a = A/rho_a (1 - f)^2/(f^3 + q), in m/s^2, with the liquid fraction f, the
/// velocity v* that the particle would have at the end of the step without it, and the sum D of all such rates, L
/// included: a Darcy drag towards rest, backward in time, so that it does not limit the step. The Carman-Kozeny law of
/// mush; ice stands still.
///
/// In a fluid beside Melting, where it freezes in a mould or skeleton that does not move, which takes up the momentum:
/// the cheapest way to hold ice, and the stiffest.
///
/// Not if the skeleton moves or ice floats: FrozenDrag and FrozenStress.
///
/// Source: Voller and Prakash (1987), Eq. (13).
struct EnthalpyPorosity : NotStiff { // implicit: no limit on the step
    using Parameters = FrozenDragParameters;
    static constexpr bool within_phases = true;
    struct Rate {
        using reads = Fields<density, liquid_fraction>;
        using adds = Fields<drag_rate>;
        static constexpr bool in_packs = true;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            return detail::mush_drag(parameters, a[liquid_fraction]) / a[density];
        }
    };
    struct Slow {
        using reads = Fields<density, liquid_fraction, velocity, acceleration, mobility, drag_rate>;
        using adds = Fields<implicit_acceleration>;
        static constexpr bool in_packs = true;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            const auto rate =
                detail::in_a_step(a.time_step) * detail::mush_drag(parameters, a[liquid_fraction]) / a[density];
            return (-rate / (1 + a.time_step * detail::yielding_rate(a))) * detail::expected_velocity(a, a.time_step);
        }
    };
    using parts = Parts<Rate, Slow>;
};

} // namespace imbibe
