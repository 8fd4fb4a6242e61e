// The terms of a solid with a stress rate whose kernel gradients are corrected: a velocity gradient that is exact at
// free surfaces too, and the force that is its counterpart.
//
//   struct Rubber : Solid<LinearState,
//                         CurrentCorrection<K>,           // L = M^-1 from the present neighbours
//                         CorrectedContinuity<K>,         // dv/dx, L -> drho/dt
//                         CorrectedVelocityGradient<K>,   // v, L -> dv/dx
//                         JaumannStress,                  // dv/dx -> dS/dt
//                         CorrectedStressForce<K>> {};    // S, p, L -> dv/dt
#pragma once

#include <imbibe/fluid/corrected_gradients.hpp>
#include <imbibe/solid/velocity_gradient.hpp>

namespace imbibe {

/// dv_i/dx_j = - sum_b (m_b/rho_b) (v_a - v_b)_i (L_a grad_a W_ab)_j, in 1/s, with L of CurrentCorrection, which must
/// stand beside it. Component (i, j) is dv_i/dx_j.
///
/// In place of VelocityGradient: exact to rounding for a velocity that is linear in space, for any arrangement of the
/// particles and at free surfaces. A block of a square lattice with a support of 2.6 spacings, in simple shear, should
/// have S_xy = G sin(g) by JaumannStress at the shear g. With VelocityGradient it is off inside by 1.5 % of G at g = 1
/// and by 8.1 % at g = pi, at the surface by up to 63 % and 105 %. With this term only the acute corners are off, which
/// are drawn out to threads (tests/terms/test_corrected_solid.cpp): a gradient is not exact where L is not full, at a
/// particle without neighbours in all directions (see CurrentCorrection).
///
/// With CorrectedStressForce and CorrectedContinuity. Not with StressForce, which is not its counterpart: energy grows,
/// by 6.7 % within ten periods of a bar that swings along itself, and no less with steps half as long (the same test).
///
/// Source: Randles and Libersky (1996); Bonet and Lok (1999).
template <class Kernel = WendlandC2, auto velocity_field = velocity>
struct CorrectedVelocityGradient {
    using effect = effects::velocity_gradient;
    using corrected_kernel = Kernel;
    using reads = Fields<mass, density, velocity_field, gradient_correction>;
    using adds = Fields<velocity_gradient>;

    IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        return outer(-(b[mass] / b[density] * ab.gradient(Kernel{})) * (a[velocity_field] - b[velocity_field]),
                     a[gradient_correction] * ab.offset);
    }
};

/// sigma L, Pa, with the Cauchy stress sigma = S - p 1: what CorrectedStressForce prepares once per particle.
struct CorrectedStress : Field<Rank::tensor> {
    static constexpr std::string_view name = "corrected_stress", unit = "Pa";
};
inline constexpr CorrectedStress corrected_stress{};

/// dv_a/dt = 1/m_a sum_b V_a V_b (sigma_a L_a + sigma_b L_b) grad_a W_ab, in m/s^2, with the volumes V = m/rho, the
/// Cauchy stress sigma = S - p 1 (tension is positive) and L of CurrentCorrection, which must stand beside it.
///
/// Use it in place of StressForce, with CorrectedVelocityGradient and CorrectedContinuity: the force that does as much
/// work as they count strain (virtual work), so energy is conserved. Forces of a pair are equal and opposite, to the
/// last bit where the masses are equal. They are not along the line of centres, but angular momentum is conserved where
/// L is the full inverse. A free bar, ten particles across with a support of 2.6 spacings, swings along itself with a
/// period that is 0.6 % longer than that of a thin one, and keeps its energy to 0.1 % in ten periods; with
/// VelocityGradient and StressForce the period is 7.6 % longer (tests/terms/test_corrected_solid.cpp).
///
/// Not without ArtificialStress where the solid is stretched: tension makes the particles clump. Not for long or large
/// motions (see JaumannStress): a total-Lagrangian solid has corrected gradients too, from neighbours that do not
/// change.
///
/// Source: Bonet and Lok (1999), the form that follows from virtual work, as CorrectedPressure.
template <class Kernel = WendlandC2>
struct CorrectedStressForce {
    using effect = effects::pressure_force;
    using corrected_kernel = Kernel;
    struct Prepare {
        using reads = Fields<pressure, deviatoric_stress, gradient_correction>;
        using sets = Fields<corrected_stress>;
        static constexpr bool in_packs = true;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            using A = std::remove_cvref_t<decltype(a)>;
            const auto unit = symmetric_identity<typename A::Scalar, A::dimension>();
            return full(a[deviatoric_stress] - a[pressure] * unit) * full(a[gradient_correction]);
        }
    };
    struct Push {
        using reads = Fields<mass, volume, corrected_stress>;
        using adds = Fields<acceleration>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const auto per_mass = 1 / a[mass]; // does not depend on b: leaves the pair loop
            return (a[volume] * b[volume] * ab.gradient(Kernel{}) * per_mass) *
                   ((a[corrected_stress] + b[corrected_stress]) * ab.offset);
        }
    };
    using parts = Parts<Volume, Prepare, Push>;

    static constexpr const char* limit_name = CorrectedPressure<Kernel>::limit_name;
    using reductions = Parts<GreatestCorrection>;
    /// That of CorrectedPressure, s, with the speed of longitudinal waves: the longest step that holds is 1.1 to 1.8
    /// times this for squares and cubes on lattices and with disorder of 0.3 spacings, with supports of 2 to 3
    /// spacings.
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        return CorrectedPressure<Kernel>::time_step_limit(material, in);
    }
};

} // namespace imbibe
