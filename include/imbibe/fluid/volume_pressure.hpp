// The pressure force between volumes: the form for interfaces with a density jump.
#pragma once

#include <imbibe/fluid/volume.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/state/wave_speed.hpp>

namespace imbibe {

/// How VolumePressure treats a pair whose pressures have a negative sum.
enum class Tension {
    pulls, ///< they pull at each other
    none   ///< no force: the pair can part freely
};

/// dv_a/dt = - 1/m_a sum_b V_a V_b (p_a + p_b) grad_a W_ab, in m/s^2, with the volumes V = m/rho.
///
/// The force that does as much work as VolumeContinuity counts compression (virtual work), so the two together conserve
/// energy. Correct across a density jump, between fluids and between a fluid and a wall or a solid, because it averages
/// only the pressure, which is continuous there. The force of the pair is along the line of centres, equal and
/// opposite, to the last bit where the masses are equal.
///
/// In a coupling with a wall or a total-Lagrangian solid the other side's `pressure` is that of PressureExtrapolation
/// and its volume is its own m/rho. Write the term there without `Into`: both sides need the volume, and a wall that
/// does not move computes no force.
///
/// Tension::none is for the coupling of a fluid that bears some tension (the slack of DensityFloor) with walls or
/// solids that it may leave. PressureExtrapolation without suction alone is not enough: a fluid particle whose own
/// pressure is negative still pulls at the wall, and single drops stick to it.
///
/// Not for slow flow under a high pressure p: a lattice of particles resists it like an elastic solid of shear modulus
/// up to 0.07 p, or is unstable (`describe` prints the number; docs/validation.md, kolmogorov). CorrectedGradients has
/// no such resistance. Not without a remedy against clumping where the pressure is negative (DensityFloor, particle
/// shifting). Not where the volume of a particle is not m/rho.
///
/// Source: Colagrossi and Landrini (2003); the same average of volumes and pressures, Hu and Adams (2006).
template <class Kernel = WendlandC2, Tension tension = Tension::pulls>
struct VolumePressure {
    using effect = effects::pressure_force;
    using pressure_kernel = Kernel;
    struct Push {
        using reads = Fields<mass, volume, pressure>;
        using adds = Fields<acceleration>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const auto per_mass = 1 / a[mass]; // does not depend on b: leaves the pair loop
            auto sum = a[pressure] + b[pressure];
            if constexpr (tension == Tension::none)
                sum = positive_part(sum);
            return along(ab, -(a[volume] * b[volume] * sum * ab.gradient(Kernel{}) * per_mass));
        }
    };
    using parts = Parts<Volume, Push>;

    static constexpr const char* limit_name = "pressure between phases";
    /// In a coupling: that of interface_time_step, s.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in) {
        return interface_time_step(material_a, material_b, in);
    }
};

} // namespace imbibe
