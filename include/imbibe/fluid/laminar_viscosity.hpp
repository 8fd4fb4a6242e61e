// The viscosity of a Newtonian fluid by the Laplacian of a kernel made for it.
#pragma once

#include <imbibe/core/term.hpp>
#include <imbibe/kernels/viscosity_kernel.hpp>

#include <algorithm>
#include <limits>

namespace imbibe {

namespace detail {

// The dynamic viscosity of a pair of materials, Pa s, the same from either side. If neither has one, a rule of the
// scene reports it (`needs_viscosity`).
template <class A, class B>
constexpr double pair_viscosity(const A& a, const B& b) {
    constexpr bool a_has = requires {
        a.viscosity;
    }
    , b_has = requires {
        b.viscosity;
    };
    if constexpr (!a_has && !b_has)
        return 0;
    else if constexpr (!b_has)
        return a.viscosity;
    else if constexpr (!a_has)
        return b.viscosity;
    else if (a.viscosity == b.viscosity)
        return a.viscosity;
    else
        return 2 * a.viscosity * b.viscosity / (a.viscosity + b.viscosity);
}

} // namespace detail

/// dv_a/dt = 1/rho_a sum_b eta_ab (m_b/rho_b) (v_b - v_a) Laplacian W_ab, in m/s^2.
///
/// eta_ab is the common dynamic viscosity if both particles have the same, the only one if the other phase, such as a
/// solid, has none, and otherwise the harmonic mean 2 eta_a eta_b/(eta_a + eta_b), which lets the shear stress pass an
/// interface unchanged. So the fluid slips along a wall with viscosity 0, and sticks to a wall with the fluid's
/// viscosity. eta_ab is the same from both sides: the force of the pair is equal and opposite, to the last bit where
/// the masses are equal. In a Coupling this is the viscous part of the paper's Eqs. (23) and (25).
///
/// In two dimensions give it ViscosityKernel2D. The Laplacian of the kernel must not be negative anywhere: there the
/// term would amplify motion.
///
/// Not for accurate drag on coarse or disordered particles, where this form does not converge. Not where angular
/// momentum must be conserved: its forces are not central.
///
/// Source: Mueller, Charypar and Gross (2003); the paper, Eq. (12), with two slips mended: there the velocity
/// difference has the sign that amplifies motion, and 1/rho_b is missing.
template <class Kernel = ViscosityKernel>
struct LaminarViscosity {
    using effect = effects::viscous_force;
    static constexpr bool needs_viscosity = true;
    using reads = Fields<mass, density, velocity>;
    using adds = Fields<acceleration>;

    IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        const double eta = detail::pair_viscosity(a.material, b.material);
        // v_a - v_b, which other terms of the sweep have, too
        return -(eta * b[mass] / (a[density] * b[density]) * ab.laplacian(Kernel{})) * (a[velocity] - b[velocity]);
    }

    static constexpr const char* limit_name = "viscosity";
    /// 0.125 H^2 rho/eta in 2D (Morris, Fox and Zhu 1997), 0.105 H^2 rho/eta in 3D, s; infinite without viscosity. With
    /// the viscosity kernels no wave on a square or cubic lattice of 1.1 to 4 spacings a support decays faster than at
    /// the rate 15.1 and 18.1 eta/(rho H^2), which allows 0.132 and 0.111.
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        return time_step_limit(material, material, in);
    }
    /// The same between two phases, with the smaller density.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in) {
        const double eta = detail::pair_viscosity(material_a, material_b);
        const double rho = std::min(material_a.density, material_b.density);
        const double share = in.dimension == 2 ? 0.125 : 0.105;
        return eta > 0 ? share * sq(in.support_radius) * rho / eta : std::numeric_limits<double>::infinity();
    }
};

} // namespace imbibe
