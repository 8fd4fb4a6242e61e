// The terms of a fluid with corrected kernel gradients: continuity, pressure and viscosity that stay accurate for
// disordered particles, few neighbours and free surfaces.
#pragma once

#include <imbibe/fluid/gradient_correction.hpp>
#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/fluid/volume.hpp>
#include <imbibe/state/wave_speed.hpp>

#include <algorithm>
#include <cmath>

namespace imbibe {

namespace detail {

template <class Term>
inline constexpr bool is_current_correction = false;
template <class Kernel>
inline constexpr bool is_current_correction<CurrentCorrection<Kernel>> = true;
template <class Kernel>
inline constexpr bool is_current_correction<InnerCorrection<Kernel>> = true;

template <class List>
inline constexpr bool any_corrects = false;
template <class... Term>
inline constexpr bool any_corrects<TypeList<Term...>> = (is_current_correction<Term> || ...);

// Is CurrentCorrection or InnerCorrection one of the terms of the particle's phase?
template <class Particle>
inline constexpr bool corrects_gradients = false;
template <class Particle>
requires requires {
    typename Particle::Material::terms;
}
inline constexpr bool corrects_gradients<Particle> = any_corrects<typename Particle::Material::terms>;

// L of a particle in a pair: its own, or that of the other if its phase has none (a wall, a solid).
template <class Particle, class Other>
IMBIBE_INLINE constexpr auto shown_correction(const Particle& particle, const Other& other) {
    if constexpr (corrects_gradients<Other> && !corrects_gradients<Particle>)
        return other[gradient_correction];
    else
        return particle[gradient_correction];
}

// m_b (eta_a + eta_b)/(rho_a rho_b) (x_ab . L_ab grad_a W_ab)/|x_ab|^2 of CorrectedViscosity, 1/s.
template <class Kernel>
IMBIBE_INLINE constexpr auto corrected_viscous_rate(const auto& a, const auto& b, const auto& ab) {
    const double eta = viscosity_sum(a.material, b.material);
    const auto both = (shown_correction(a, b) + shown_correction(b, a)) * ab.offset;
    const auto correction = dot(ab.offset, both) * ab.inverse_squared_distance();
    return (0.5 * eta) * b[mass] / (a[density] * b[density]) * correction * ab.gradient(Kernel{});
}

} // namespace detail

/// sum_b V_b sym((v_b - v_a) (x) grad_a W_ab), 1/s: the rate of strain before its correction.
struct RawStrainRate : Field<Rank::symmetric_tensor> {
    static constexpr std::string_view name = "raw_strain_rate", unit = "1/s";
};
inline constexpr RawStrainRate raw_strain_rate{};

/// drho_a/dt = rho_a sum_b V_b (v_a - v_b) . L_a grad_a W_ab, in kg/m^3/s, with the volumes V = m/rho and L of
/// CurrentCorrection or InnerCorrection, which must stand beside it: exact for velocities that are linear in space,
/// wherever L is the full inverse. It is computed as - rho L:E from the raw rate of strain E, so that L and the sums E
/// take one sweep.
///
/// Use it in the fluid, together with CorrectedPressure. Its couplings need CorrectionNeighbours `Into` the fluid,
/// which is checked, and `Into` the fluid this term or VolumeContinuity, which keeps a film off the wall for longer.
///
/// Not where the density must stay the sum of the masses around a particle: over a long run in a closed box it drifts
/// from it, by per mille or, with a background pressure in all of the water, by much (docs/validation.md, cavity).
///
/// Source: Randles and Libersky (1996); Bonet and Lok (1999).
template <class Kernel = WendlandC2>
struct CorrectedContinuity {
    using effect = effects::continuity_equation;
    /// A wall that counts in one sum and not in the other would throw water off.
    using beside_in_couplings = CorrectionNeighbours<Kernel>;
    using corrected_kernel = Kernel;
    struct Sum {
        using reads = Fields<volume, velocity>;
        using adds = Fields<raw_strain_rate>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            return symmetric_part(outer(b[volume] * ab.gradient(Kernel{}) * (b[velocity] - a[velocity]), ab.offset));
        }
    };
    struct Rate {
        using reads = Fields<density, gradient_correction, raw_strain_rate>;
        using adds = Fields<density_rate>;
        static constexpr bool in_packs = true;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            return -a[density] * dot(a[gradient_correction], a[raw_strain_rate]);
        }
    };
    using parts = Parts<Volume, Sum, Rate>;

    static constexpr const char* limit_name = "pressure between phases";
    /// In a coupling: that of interface_time_step, s.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in) {
        return interface_time_step(material_a, material_b, in);
    }
};

/// dv_a/dt = - 1/m_a sum_b V_a V_b (p_a L_a + p_b L_b) grad_a W_ab, in m/s^2, with the volumes V = m/rho and L of
/// CurrentCorrection, which must stand beside it.
///
/// The force that does as much work as CorrectedContinuity counts compression (virtual work), so energy is conserved.
/// Forces of a pair are equal and opposite, to the last bit where the masses are equal. They are not along the line of
/// centres, but angular momentum is conserved where L is the full inverse.
///
/// For waves and vortices that are to keep their energy (docs/validation.md, standing-wave; docs/accuracy.md). In a
/// coupling a wall or a solid shows the fluid's L, and its pressure is that of PressureExtrapolation: `Coupling<Water,
/// Wall, Into<Water, CorrectionNeighbours<>>, Into<Water, CorrectedContinuity<>>, Into<Wall, PressureExtrapolation<>>,
/// CorrectedPressure<>>`.
///
/// Not without something that keeps particles in order, as the errors of VolumePressure do: use ParticleShifting where
/// the flow stretches them, and 3 spacings of support where pressures fall below zero. Not for splashes: a film that
/// runs out over a wall sinks into it, because the loss in height and the gain in length cancel, however few particles
/// carry the film; with VolumePressure and VolumeContinuity in the coupling it does so later. A Guard detects it.
///
/// Source: Bonet and Lok (1999), the form that follows from virtual work. With p_a L_b + p_b L_a in its place (Zhang,
/// Zhu and Hu 2024) energy and angular momentum are not conserved.
template <class Kernel = WendlandC2>
struct CorrectedPressure {
    using effect = effects::pressure_force;
    using beside_in_couplings = CorrectionNeighbours<Kernel>;
    using corrected_kernel = Kernel;
    struct Push {
        using reads = Fields<mass, volume, pressure, gradient_correction>;
        using adds = Fields<acceleration>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const auto per_mass = 1 / a[mass]; // does not depend on b: leaves the pair loop
            const auto both =
                a[pressure] * detail::shown_correction(a, b) + b[pressure] * detail::shown_correction(b, a);
            return -(a[volume] * b[volume] * ab.gradient(Kernel{}) * per_mass) * (both * ab.offset);
        }
    };
    using parts = Parts<Volume, Push>;

    static constexpr const char* limit_name = "corrected gradients";
    using reductions = Parts<GreatestCorrection>;
    /// That of sound, acoustic_time_step, over the cube root of 1 + 1.4 (D - 1), s, with the greatest component D of
    /// any L, at least 1: 2 to 5 at a free surface, to 12 in spray. Fitted to the greatest singular values of the
    /// corrected gradient of squares, cubes and spray with free surfaces, with supports of 1.5 to 4 spacings and
    /// disorder of up to 0.3: the longest step that holds is 1 to 1.8 times this.
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        return acoustic_time_step(material, in) / std::cbrt(1 + 1.4 * (std::max(in.greatest, 1.0) - 1));
    }
    /// Between two phases the limit of VolumePressure, s: the lighter side oscillates, and its continuity may be
    /// another one.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in) {
        return interface_time_step(material_a, material_b, in);
    }
};

/// dv_a/dt = sum_b m_b (eta_a + eta_b)/(rho_a rho_b) (x_ab . L_ab grad_a W_ab)/|x_ab|^2 (v_a - v_b), in m/s^2, with the
/// mean L_ab = (L_a + L_b)/2 of CurrentCorrection, which must stand beside it, and the dynamic viscosities eta.
///
/// MorrisViscosity without the error of its lattice sum: on a lattice of any kernel and support it is exact for
/// velocities that are quadratic in space. At walls it sees the wall's velocity; for no-slip CorrectedNoSlipViscosity.
///
/// Not at a free surface, where it treats the missing neighbours as if they moved along; ClearyViscosity is correct
/// there. Not where angular momentum must be conserved exactly.
///
/// Source: Morris, Fox and Zhu (1997), Eq. (22), with the correction of Bonet and Lok (1999). Own: that its second
/// moments are those of the gradients' correction.
template <class Kernel = WendlandC2>
struct CorrectedViscosity {
    using effect = effects::viscous_force;
    static constexpr bool needs_viscosity = true;
    using beside_in_couplings = CorrectionNeighbours<Kernel>;
    using corrected_kernel = Kernel;
    using reads = Fields<mass, density, velocity, gradient_correction>;
    using adds = Fields<acceleration>;

    IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        return detail::corrected_viscous_rate<Kernel>(a, b, ab) * (a[velocity] - b[velocity]);
    }

    static constexpr const char* limit_name = MorrisViscosity<Kernel>::limit_name;
    using reductions = Parts<GreatestCorrection>;
    /// That of MorrisViscosity, over the cube root of 3/4 of the greatest component of any L where that is more than 1,
    /// s; as for CorrectedPressure, the longest step that holds is 1 to 1.8 times this.
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        return MorrisViscosity<Kernel>::time_step_limit(material, in) / std::cbrt(std::max(0.75 * in.greatest, 1.0));
    }
    /// The same between two phases.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in) {
        return MorrisViscosity<Kernel>::time_step_limit(material_a, material_b, in);
    }
};

} // namespace imbibe
