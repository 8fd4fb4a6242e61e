// Physical viscosity from first derivatives of any kernel, in two and three dimensions.
#pragma once

#include <imbibe/fluid/pairwise_laplacian.hpp>
#include <imbibe/kernels/wendland.hpp>

#include <algorithm>

namespace imbibe {

namespace detail {

// The viscosity that a material has in a pair. A fluid has its own. A solid, and a wall without one, take that of the
// fluid they touch.
template <class Material>
constexpr double shown_viscosity(const Material& material, double of_the_other) {
    if constexpr (!requires { material.viscosity; })
        return of_the_other;
    else if constexpr (!Material::moves)
        return material.viscosity > 0 ? material.viscosity : of_the_other;
    else
        return material.viscosity;
}

// eta_a + eta_b of a pair, Pa s.
constexpr double viscosity_sum(const auto& material_a, const auto& material_b) {
    const double own = shown_viscosity(material_a, 0.0), other = shown_viscosity(material_b, own);
    return shown_viscosity(material_a, other) + other;
}

} // namespace detail

/// dv_a/dt = sum_b m_b (eta_a + eta_b)/(rho_a rho_b) (x_ab . grad_a W_ab)/|x_ab|^2 (v_a - v_b), in m/s^2, with the
/// dynamic viscosity eta of the two materials.
///
/// (x_ab . grad_a W_ab)/|x_ab|^2 is negative: the faster particle is slowed. For laminar flow in 2D and 3D (Poiseuille,
/// Couette, pores), and across phases with different viscosity or density. Linear momentum is conserved to the last bit
/// where the masses are equal.
///
/// The original divides by |x_ab|^2 + 0.01 h^2 to stay finite. Here grad W = F x_ab, and F itself is evaluated, which
/// is finite. With the 0.01 h^2 the viscosity would be 1 to 2 % too low.
///
/// Not where angular momentum must be conserved exactly (the force is not along the line of centres): MonaghanViscosity
/// does. Not with a kernel whose slope does not vanish at the centre (Spiky). In a coupling with a wall every layer has
/// the wall's own velocity, where reflection would need the opposite of the liquid's: the drag is too weak, and no-slip
/// holds only roughly. For second-order no-slip take `Into<Wall, NoSlipVelocity<>>, NoSlipViscosity<>` in its place.
///
/// Source: Morris, Fox and Zhu (1997), Eq. (22).
template <class Kernel = WendlandC2>
struct MorrisViscosity {
    using effect = effects::viscous_force;
    static constexpr bool needs_viscosity = true;
    using reads = Fields<mass, density, velocity>;
    using adds = Fields<acceleration>;

    IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        const double eta = detail::viscosity_sum(a.material, b.material);
        return (eta * b[mass] / (a[density] * b[density]) * ab.gradient(Kernel{})) * (a[velocity] - b[velocity]);
    }

    static constexpr const char* limit_name = "viscous diffusion";
    /// H^2 rho/(1.3 S eta), s, with S = 14 for WendlandC2: 0.055 H^2/nu.
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        return time_step_limit(material, material, in);
    }
    /// The same between two phases, with the mean viscosity and the lighter density.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in) {
        const double eta = 0.5 * detail::viscosity_sum(material_a, material_b);
        return detail::pairwise_diffusion_limit<Kernel>(eta / std::min(material_a.density, material_b.density), in);
    }
};

} // namespace imbibe
