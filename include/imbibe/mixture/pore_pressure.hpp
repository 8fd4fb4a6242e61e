// The forces between a skeleton and the fluid in its pores.
#pragma once

#include <imbibe/mixture/in_pores.hpp>
#include <imbibe/mixture/porous_skeleton.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace imbibe {

/// The forces of the pore pressure p and the wetting, from their work as the porosity n of PoreSpace changes with the
/// positions of the particles: on a particle a of the fluid
///
///     F_a = - V_a (p_a - kappa) sum_b (v_b - s_a V_b)/max(B_a, 0.95) grad_a W_ab, in N,
///
/// with its volume V_a = m/rho, the wetting kappa, s = 1 - n where B > 0.95 and 0 outside, and the opposite on each
/// particle b of the skeleton with its solid and present volume v and V. PoreContents has the forces from the change of
/// the porosity by the deformation of the skeleton.
///
/// VolumePressure gives the fluid the force - grad P. With this force the fluid has - n grad p, and the skeleton has
/// its buoyancy, - (1 - n) grad p. All forces are the derivative of the energy that InPores stores, so energy is
/// conserved. In a uniform skeleton F is 0 pair by pair, for any arrangement of particles.
///
/// In the coupling of a fluid with InPores and a solid with PorousSkeleton: `PoreSpace`, `PoreContents`, this and
/// `DarcyDrag`. CouplingOf lists them for a SeepingFluid.
///
/// Not between the skeleton and a wall: how much of it the wall bears depends on their contact. Walls push the fluid in
/// the pores with P.
///
/// Source: the equations, Biot (1941); the sums, own, by virtual work.
template <class Kernel = WendlandC2>
struct PorePressure {
    static constexpr bool between_fluid_and_other = true;
    static constexpr bool overlapping = true; ///< no warning that the two overlap
    struct Push {
        using reads =
            Fields<mass, volume, pore_pressure, wetting, porosity, skeleton_sum, solid_volume, present_volume>;
        using adds = Fields<acceleration>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const auto& f = detail::one_of<true>(a, b);
            const auto& s = detail::one_of<false>(a, b);
            const auto change = s[solid_volume] - detail::inner_solid_share(f) * s[present_volume];
            return along(ab, -(f[volume] * (f[pore_pressure] - f[wetting]) * detail::per_solid_sum(f) * change *
                               ab.gradient(Kernel{}) / a[mass]));
        }
    };
    using parts = Parts<Volume, Push>;

    static constexpr const char* limit_name = "pore pressure";
    /// max(spacing, 0.6 H)/(c + v), s, with c^2 = c_f^2 (1 + 0.36 (1 - n)^2 rho_f/(n rho_s)) + c_s^2, the fluid's speed
    /// of sound c_f, the skeleton's porosity n, its density rho_s per total volume and its speed of longitudinal waves
    /// c_s: sound in the two together. 0.36, instead of 1 for long waves, is that of interface_time_step.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in) {
        if constexpr (!detail::is_fluid<std::remove_cvref_t<decltype(material_a)>>)
            return time_step_limit(material_b, material_a, in);
        else {
            const double n = detail::skeleton_of(material_a, material_b).porosity;
            const double together = 1 + 0.36 * sq(1 - n) * material_a.density / (n * material_b.density);
            const double c =
                std::sqrt(sq(material_a.sound_speed) * together + sq(material_b.longitudinal_wave_speed()));
            return std::max(std::min(in.spacing, in.other_spacing), 0.6 * in.support_radius) /
                   (c + std::max(in.max_speed, in.other_max_speed));
        }
    }
};

/// The contents of the pores at a particle b of a skeleton: the sum_a V_a W_ab of the volumes V = m/rho of the fluid's
/// particles a, from which Saturation follows, and
///
///     q_b = sum_a V_a (p_a - kappa) s_a/B_a W_ab, in Pa,
///
/// with the symbols of PorePressure: (1 - n) (p - kappa), the stress with which the fluid and its wetting resist a
/// volume change of the skeleton. Together with P it is p: the total stress is that of the drained skeleton, and p.
///
/// Goes `Into` the skeleton, beside PorePressure.
///
/// Not without PorePressure: the two are the derivative of one energy.
///
/// Source: that of PorePressure.
template <class Kernel = WendlandC2>
struct PoreContents {
    static constexpr bool one_sided = true;
    struct Sum { // a: skeleton, b: fluid
        using reads = Fields<volume, pore_pressure, wetting, porosity, skeleton_sum>;
        using adds = Fields<fluid_sum, pore_stress>;

        IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
            const auto share = b[volume] * ab.value(Kernel{});
            return values(share, share * (b[pore_pressure] - b[wetting]) * detail::inner_solid_share(b) *
                                     detail::per_solid_sum(b));
        }
    };
    using parts = Parts<Volume, Sum>;
};

} // namespace imbibe
