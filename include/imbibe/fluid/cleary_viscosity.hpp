// Physical viscosity along the line of centres: the one that keeps angular momentum.
#pragma once

#include <imbibe/fluid/morris_viscosity.hpp>

namespace imbibe {

namespace detail {

// 2 eta_a eta_b/(eta_a + eta_b) of a pair, Pa s; 0 if either is 0.
constexpr double harmonic_viscosity(const auto& material_a, const auto& material_b) {
    const double given = shown_viscosity(material_a, 0.0), eta_b = shown_viscosity(material_b, given);
    const double eta_a = shown_viscosity(material_a, eta_b);
    return eta_a == eta_b ? eta_a : 2 * eta_a * eta_b / (eta_a + eta_b);
}

} // namespace detail

/// dv_a/dt = 2 (dim + 2) sum_b m_b eta_ab/(rho_a rho_b) (v_a - v_b).x_ab/|x_ab|^2 grad_a W_ab, in m/s^2, with the
/// harmonic mean eta_ab = 2 eta_a eta_b/(eta_a + eta_b) of the dynamic viscosities.
///
/// The force of the pair is along the line of centres, equal and opposite, to the last bit where the masses are equal:
/// linear and angular momentum are conserved. The harmonic mean lets the shear stress pass an interface between fluids
/// unchanged. A solid, or a wall without a viscosity of its own, takes the fluid's, and the fluid sticks to it. For
/// flows with rotation (the square patch, vortices, drops) and free surfaces, where it is consistent with zero stress
/// (Colagrossi, Antuono, Souto-Iglesias and Le Touze 2011).
///
/// Not where div v matters: its limit is eta (Laplacian v + 2 grad div v)/rho. Not for particles that stay on a lattice
/// (flow between plates), where it depends on the direction: with 3 spacings of WendlandC2 the viscosity is 11 % too
/// low for shear along the axes of a square lattice and 11 % too high along its diagonals, with 4 spacings 4 %;
/// MorrisViscosity, 0.3 % there, also allows a step 2.7 times as long. Not with a kernel whose slope does not vanish at
/// the centre (Spiky).
///
/// Source: Cleary (1998), there with a factor found by calibration, 4.96333, in the place of dim + 2; Monaghan (2005).
/// 2 (dim + 2) is that of the integral over smooth flow. The original's 0.01 h^2 in the denominator is left out as in
/// MorrisViscosity.
template <class Kernel = WendlandC2>
struct ClearyViscosity {
    using effect = effects::viscous_force;
    static constexpr bool needs_viscosity = true;
    using reads = Fields<mass, density, velocity>;
    using adds = Fields<acceleration>;

    IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        constexpr int dim = std::remove_cvref_t<decltype(a)>::dimension;
        const double eta = detail::harmonic_viscosity(a.material, b.material);
        const auto approach = dot(a[velocity] - b[velocity], ab.offset) * ab.inverse_squared_distance();
        return along(ab,
                     (2 * (dim + 2) * eta) * b[mass] / (a[density] * b[density]) * approach * ab.gradient(Kernel{}));
    }

    static constexpr const char* limit_name = MorrisViscosity<Kernel>::limit_name;
    /// dim/(dim + 2) of the limit of MorrisViscosity over 1.4 in 2D and 1.6 in 3D, s: 0.02 H^2/nu with WendlandC2.
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        return time_step_limit(material, material, in);
    }
    /// The same between two phases, with the lighter density.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in) {
        const double eta = detail::harmonic_viscosity(material_a, material_b) * (in.dimension + 2) / in.dimension;
        return detail::central_diffusion_limit<Kernel>(eta / std::min(material_a.density, material_b.density), in);
    }
};

} // namespace imbibe
