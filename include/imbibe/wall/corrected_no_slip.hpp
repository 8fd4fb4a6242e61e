// A no-slip wall for a fluid with corrected kernel gradients.
#pragma once

#include <imbibe/fluid/corrected_gradients.hpp>
#include <imbibe/wall/no_slip.hpp>

namespace imbibe {

/// CorrectedViscosity between a fluid with CurrentCorrection and a wall or solid that shows the velocity of
/// NoSlipVelocity: dv_a/dt = sum_b m_b (eta_a + eta_b)/(rho_a rho_b) (x_ab . L grad_a W_ab)/|x_ab|^2 (u_a - u_b), in
/// m/s^2, with u = v in the fluid, u = v_shown in the wall, and L of the fluid's particle.
///
/// Together with `Into<Wall, NoSlipVelocity<>>` and `Into<Water, CorrectionNeighbours<>>`. The force on a solid is
/// equal and opposite.
///
/// Not inside a fluid, and not between two fluids: that is CorrectedViscosity.
///
/// Source: Adami, Hu and Adams (2012); see CorrectedViscosity.
template <class Kernel = WendlandC2>
struct CorrectedNoSlipViscosity {
    static constexpr bool between_fluid_and_other = true;
    using effect = effects::viscous_force;
    using corrected_kernel = Kernel;
    using reads = Fields<mass, density, velocity, no_slip_velocity, gradient_correction>;
    using adds = Fields<acceleration>;

    IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        return detail::corrected_viscous_rate<Kernel>(a, b, ab) *
               (detail::velocity_at_wall(a) - detail::velocity_at_wall(b));
    }

    static constexpr const char* limit_name = MorrisViscosity<Kernel>::limit_name;
    /// That of MorrisViscosity, s.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in) {
        return MorrisViscosity<Kernel>::time_step_limit(material_a, material_b, in);
    }
};

} // namespace imbibe
