// No-slip walls and solids for a liquid with GeneralisedNewtonianViscosity.
#pragma once

#include <imbibe/fluid/generalised_newtonian.hpp>
#include <imbibe/wall/no_slip.hpp>

namespace imbibe {

/// The wall's or solid's share of the rate of strain that sets the liquid's viscosity: E_a += sum_b V_b sym((u_b - v_a)
/// (x) grad_a W_ab), 1/s, with the velocity u of NoSlipVelocity.
///
/// Goes into the liquid, together with NoSlipApparentViscosity. The wall or solid needs its own Volume.
///
/// Not without NoSlipVelocity, nor for a liquid without GeneralisedNewtonianViscosity.
///
/// Source: Adami, Hu and Adams (2012) for u; see GeneralisedNewtonianViscosity.
template <class Kernel = WendlandC2>
struct NoSlipStrainRate {
    static constexpr bool between_fluid_and_other = true;
    struct Sum { // a: liquid, b: wall or solid
        using reads = Fields<volume, velocity, no_slip_velocity>;
        using adds = Fields<strain_rate>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const auto apart = detail::velocity_at_wall(b) - detail::velocity_at_wall(a);
            return symmetric_part(outer(b[volume] * ab.gradient(Kernel{}) * apart, ab.offset));
        }
    };
    using parts = Parts<Volume, Sum>;
};

namespace detail {

// The apparent viscosity of the pair's liquid, which also counts for the other side.
template <class A, class B>
IMBIBE_INLINE constexpr auto viscosity_at_wall(const A& a, const B& b) {
    if constexpr (is_fluid<typename A::Material>)
        return a[apparent_viscosity];
    else
        return b[apparent_viscosity];
}

} // namespace detail

/// GeneralisedNewtonianViscosity between its liquid and a wall or solid that shows the velocity of NoSlipVelocity:
/// dv_a/dt = sum_b m_b 2 eta/(rho_a rho_b) (x_ab . grad_a W_ab)/|x_ab|^2 (u_a - u_b), in m/s^2, with the apparent
/// viscosity eta of the liquid's particle, u = v in the liquid and u = v_shown in the wall. The force on a solid is
/// equal and opposite.
///
/// Not inside a liquid, and not between two.
///
/// Source: as NoSlipViscosity.
template <class Kernel = WendlandC2>
struct NoSlipApparentViscosity {
    static constexpr bool between_fluid_and_other = true;
    using effect = effects::viscous_force;
    using reads = Fields<mass, density, velocity, no_slip_velocity, apparent_viscosity>;
    using adds = Fields<acceleration>;

    IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        const auto eta = 2 * detail::viscosity_at_wall(a, b);
        return (eta * b[mass] / (a[density] * b[density]) * ab.gradient(Kernel{})) *
               (detail::velocity_at_wall(a) - detail::velocity_at_wall(b));
    }
};

} // namespace imbibe
