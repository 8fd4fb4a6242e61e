// Fluid pressure on the surface of a solid, along the surface normal.
//
//   struct Sponge  : Solid<..., ReferenceSurfaceNormal<>, ...> {};      // total Lagrangian; SurfaceNormal<> for others
//   struct Contact : Coupling<Water, Sponge, SurfaceNormalPressure<>, Into<Water, VolumeContinuity<WendlandC2>>> {};
#pragma once

#include <imbibe/fluid/volume.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/state/wave_speed.hpp>

namespace imbibe {

/// - sum_b V_b grad_a W_ab, 1/m: points out of the solid, about 1/H long at its surface, zero deep inside.
struct SurfaceNormalSum : Field<Rank::vector> {
    static constexpr std::string_view name = "surface_normal_sum", unit = "1/m";
};
inline constexpr SurfaceNormalSum surface_normal_sum{};

/// The outward normal of a solid at the particles of its surface, zero inside it, without unit.
struct SurfaceNormalField : Field<Rank::vector> {
    static constexpr std::string_view name = "surface_normal", unit = "1";
};
inline constexpr SurfaceNormalField surface_normal{};

namespace detail {

// A vector along `direction`, of unit length if the sum of the kernel gradients is at least 0.3/H, of zero length if it
// is below 0.1/H, where it is noise.
template <class V>
IMBIBE_INLINE constexpr V trusted_normal(const V& direction, const V& sum, double support_radius) {
    using T = typename V::Scalar;
    const T trust = min(positive_part((support_radius * norm(sum) - 0.1) / 0.2), T(1));
    return (trust / max(norm(direction), T(1e-30))) * direction;
}

} // namespace detail

/// n_a = N_a/|N_a|, N_a = - sum_b V_b grad_a W_ab over the solid's own particles where they are now, V = m/rho; zero
/// where |N_a| is small (inside).
///
/// A term of an updated-Lagrangian solid, whose neighbours change anyway. At an edge it points between the two faces.
///
/// Not for a solid of single particles or of one layer: it has no interior.
///
/// Source: Antoci, Gallati and Sibilla (2007), the normal from the gradient of the kernel sum.
template <class Kernel = WendlandC2>
struct SurfaceNormal {
    struct Sum {
        using reads = Fields<mass, density>;
        using adds = Fields<surface_normal_sum>;

        IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
            return along(ab, -(b[mass] / b[density] * ab.gradient(Kernel{})));
        }
    };
    struct Unit {
        using reads = Fields<surface_normal_sum>;
        using sets = Fields<surface_normal>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            const auto N = a[surface_normal_sum];
            return detail::trusted_normal(N, N, a.material.support_radius);
        }
    };
    using parts = Parts<Sum, Unit>;
};

/// n_a = F^-T N_a/|F^-T N_a|, N_a = - sum_b V_b grad_a W_ab over the stress-free neighbours, summed once; zero where
/// |N_a| is small (inside). F^-T turns the normal of the stress-free surface into that of the deformed one.
///
/// A term of a total-Lagrangian solid. At an edge it points between the two faces.
///
/// Not for a solid of single particles or of one layer: it has no interior.
///
/// Source: as SurfaceNormal; how a normal deforms: Nanson's formula, any textbook of continuum mechanics.
template <class Kernel = WendlandC2>
struct ReferenceSurfaceNormal {
    struct Sum {
        using neighbourhood = Reference;
        static constexpr bool once = true;
        using reads = Fields<mass>;
        using adds = Fields<surface_normal_sum>;

        IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
            return along(ab, -(b[mass] * (1 / b.material.density) * ab.gradient(Kernel{})));
        }
    };
    struct Turn {
        using reads = Fields<surface_normal_sum, deformation_gradient>;
        using sets = Fields<surface_normal>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            const auto N = a[surface_normal_sum];
            const auto cofactor = transpose(adjugate(a[deformation_gradient])); // J F^-T
            return detail::trusted_normal(cofactor * N, N, a.material.support_radius);
        }
    };
    using parts = Parts<Sum, Turn>;
};

/// m_s dv_s/dt = - sum_f V_f V_s 2 p_f [n_s (n_s . grad_s W) + (1 - n_s^2) grad_s W], in N, for a particle s of the
/// solid and the particles f of the fluid, with grad_s W towards the fluid; on the fluid the opposite. n_s is the
/// surface normal (SurfaceNormal or ReferenceSurfaceNormal), of unit length at the surface and zero inside: of the
/// force of every pair with a surface particle only the part along the normal is left; deeper particles, which have no
/// normal, are pushed along the line of centres.
///
/// 2 sum_f V_f p_f grad_s W is the SPH sum of the fluid's pressure over the surface; the factor 2 makes up for the half
/// of the kernel that lies in the solid, so the total force is pressure times area. It uses only the fluid's pressure:
/// the solid needs none, and no PressureExtrapolation.
///
/// For couplings of a fluid and a solid with a smooth surface: water slides along it without feeling its particles. The
/// force of a pair is equal and opposite, to the last bit where the masses are equal. With half a metre of water on a
/// soft plate, the plate sags 0.9 % less than under the same weight without water (PressureExtrapolation: 0.5 %).
///
/// Not where angular momentum must be conserved to round-off: the force of a pair is not central. Not where the weight
/// of one layer of particles matters: the pressure at the surface is that of the fluid's particles, half a spacing off.
/// A negative pressure pulls the solid. KernelRepulsion with a range below one spacing may stand beside it, as a guard
/// against single particles that sink in.
///
/// Source: Antoci, Gallati and Sibilla (2007): an SPH sum for the surface integral of the fluid's pressure, along
/// normals from the kernel. This pairwise form, with n_s fading inside: own.
template <class Kernel = WendlandC2>
struct SurfaceNormalPressure {
    using effect = effects::pressure_force;
    static constexpr bool between_fluid_and_other = true;
    struct Push {
        using reads = Fields<mass, volume, pressure, surface_normal>;
        using adds = Fields<acceleration>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const auto per_mass = 1 / a[mass];
            const auto weight = -(2 * a[volume] * b[volume] * ab.gradient(Kernel{}) * per_mass);
            if constexpr (detail::is_fluid<typename std::remove_cvref_t<decltype(a)>::Material>)
                return (weight * a[pressure]) * projected(ab.offset, b[surface_normal]);
            else
                return (weight * b[pressure]) * projected(ab.offset, a[surface_normal]);
        }

    private:
        template <class V>
        IMBIBE_INLINE static constexpr V projected(const V& offset, const V& n) {
            return offset - squared_norm(n) * offset + dot(n, offset) * n;
        }
    };
    using parts = Parts<Volume, Push>;

    static constexpr const char* limit_name = "pressure between phases";
    /// That of interface_time_step, s.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in) {
        return interface_time_step(material_a, material_b, in);
    }
};

} // namespace imbibe
