// A no-slip wall: the velocity of the wall's particles extrapolated from the fluid, and the viscous force and the
// continuity equation that use it. Without it in the coupling the wall is free-slip.
#pragma once

#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/fluid/volume.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/wall/surface_distance.hpp>

namespace imbibe {

/// sum_f W_af, 1/m^3 (1/m^2 in 2D).
struct NoSlipWeight : Field<Rank::scalar> {
    static constexpr std::string_view name = "no_slip_weight", unit = "1/m^3";
};
inline constexpr NoSlipWeight no_slip_weight{};

/// sum_f (v_f - v_a) W_af, 1/(m^2 s).
struct NoSlipSum : Field<Rank::vector> {
    static constexpr std::string_view name = "no_slip_sum", unit = "1/(m^2 s)";
};
inline constexpr NoSlipSum no_slip_sum{};

/// sum_f (x_f - x_a) W_af, 1/m^2 (1/m in 2D).
struct NoSlipOffset : Field<Rank::vector> {
    static constexpr std::string_view name = "no_slip_offset", unit = "1/m^2";
};
inline constexpr NoSlipOffset no_slip_offset{};

/// The velocity that the fluid's viscosity uses for a wall particle, m/s.
struct NoSlipVelocityField : Field<Rank::vector> {
    static constexpr std::string_view name = "no_slip_velocity", unit = "m/s";
};
inline constexpr NoSlipVelocityField no_slip_velocity{};

/// v_shown = 2 v_a - sum_f v_f W_af / sum_f W_af, in m/s, for a particle a of a wall or a solid: the fluid's velocity
/// reflected about the wall's own, so that the two meet at the surface. v_a itself where there is no fluid.
///
/// Goes into the wall or the solid, together with NoSlipViscosity:
/// `Coupling<Water, Wall, Into<Wall, NoSlipVelocity<>>, NoSlipViscosity<>, ...>`.
///
/// Not for the continuity equation or the pressure: those use the wall's real velocity.
///
/// Source: Adami, Hu and Adams (2012), Eqs. (22) and (23).
template <class Kernel = WendlandC2>
struct NoSlipVelocity {
    static constexpr bool one_sided = true;
    struct Sum { // a: wall or solid, b: fluid
        using reads = Fields<velocity>;
        using adds = Fields<no_slip_weight, no_slip_sum>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const auto weight = ab.value(Kernel{});
            return values(weight, weight * (b[velocity] - a[velocity]));
        }
    };
    struct Reflect {
        using reads = Fields<velocity, no_slip_weight, no_slip_sum>;
        using sets = Fields<no_slip_velocity>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            return a[velocity] - a[no_slip_sum] / max(a[no_slip_weight], 1e-30);
        }
    };
    using parts = Parts<Sum, Reflect>;
};

/// v_shown = v_a - (D/d - 1) sum_f (v_f - v_a) W_af / sum_f W_af, in m/s, for a particle a of a wall or a solid: the
/// fluid's velocity extrapolated linearly through the wall's own at the surface. D = |sum_f (x_f - x_a) W_af| / sum_f
/// W_af is the distance from a to the fluid it sees, d that fluid's distance from the surface: SurfaceDistance. v_a
/// itself where there is no fluid.
///
/// In place of NoSlipVelocity, which has 1 for D/d - 1: right for the first layer, a third of it for the second. For
/// pipes of fitted particles: Poiseuille flow in one of 12 across is 2.5 % too fast, with NoSlipVelocity 6 %
/// (tests/porous/test_permeability.cpp).
///
/// Not where the fluid is a thin film or spray: D is then the distance of single particles.
///
/// Source: the straight line: Morris, Fox and Zhu (1997), section 3.5, Eq. (26), with distances to a known surface;
/// here the distances are kernel averages.
template <class Kernel = WendlandC2>
struct LinearNoSlipVelocity {
    static constexpr bool one_sided = true;
    using Prepared = SurfaceDistance;
    struct Sum { // a: wall or solid, b: fluid
        using reads = Fields<velocity>;
        using adds = Fields<no_slip_weight, no_slip_sum, no_slip_offset>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const auto weight = ab.value(Kernel{});
            return values(weight, weight * (b[velocity] - a[velocity]), -weight * ab.offset);
        }
    };
    struct Continue {
        using reads = Fields<velocity, no_slip_weight, no_slip_sum, no_slip_offset>;
        using sets = Fields<no_slip_velocity>;
        Prepared prepared{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            const auto weight = max(a[no_slip_weight], 1e-30);
            const auto D = sqrt(squared_norm(a[no_slip_offset])) / weight;
            return a[velocity] - (positive_part(D / prepared.of(D) - 1) / weight) * a[no_slip_sum];
        }
    };
    using parts = Parts<Sum, Continue>;

    /// Computed from the scene's lattice.
    template <int dim>
    static Prepared prepare(const auto&, const auto&, const Lattice<dim>& lattice) {
        return SurfaceDistance::on<Kernel>(lattice);
    }
};

namespace detail {

// The velocity for the viscosity between a fluid and something else: a fluid's own, otherwise v_shown.
IMBIBE_INLINE constexpr auto velocity_at_wall(const auto& a) {
    using Material = typename std::remove_cvref_t<decltype(a)>::Material;
    if constexpr (Material::moves && requires(const Material& m) { m.viscosity; })
        return a[velocity];
    else
        return a[no_slip_velocity];
}

} // namespace detail

/// MorrisViscosity between a fluid and a wall or solid that shows the velocity of NoSlipVelocity:
/// dv_a/dt = sum_b m_b (eta_a + eta_b)/(rho_a rho_b) (x_ab . grad_a W_ab)/|x_ab|^2 (u_a - u_b), in m/s^2, with u = v in
/// the fluid and u = v_shown in the wall. A wall or solid without a viscosity of its own shows the fluid's.
/// The force on a solid is equal and opposite.
///
/// Not inside a fluid, and not between two fluids: that is MorrisViscosity.
///
/// Source: Adami, Hu and Adams (2012); Morris, Fox and Zhu (1997), Eq. (22).
template <class Kernel = WendlandC2>
struct NoSlipViscosity {
    static constexpr bool between_fluid_and_other = true;
    using effect = effects::viscous_force;
    using reads = Fields<mass, density, velocity, no_slip_velocity>;
    using adds = Fields<acceleration>;

    IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        const double eta = detail::viscosity_sum(a.material, b.material);
        return (eta * b[mass] / (a[density] * b[density]) * ab.gradient(Kernel{})) *
               (detail::velocity_at_wall(a) - detail::velocity_at_wall(b));
    }

    static constexpr const char* limit_name = MorrisViscosity<Kernel>::limit_name;
    /// That of MorrisViscosity, s.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in) {
        return MorrisViscosity<Kernel>::time_step_limit(material_a, material_b, in);
    }
};

/// VolumeContinuity between a fluid and a wall or solid that shows the velocity of NoSlipVelocity or
/// LinearNoSlipVelocity: drho_a/dt = rho_a sum_b (m_b/rho_b) (v_a - v_shown,b) . grad_a W_ab, in kg/m^3/s. For the
/// fluid: `Into<Water, NoSlipContinuity<>>`.
///
/// Use it in place of VolumeContinuity where liquid flows slowly around obstacles. With the wall's own velocity the sum
/// overrates the flow along the wall, and where that flow changes it counts compression that does not exist. The drag
/// is then too weak: by 2.5 to 5 % for cylinders 6 to 15 particles thick in a cell of 25, and by 0.2 to 2 % with this
/// (docs/validation.md, fitted-cylinders).
///
/// Not where energy must balance exactly: the force of VolumePressure does its work along the wall's own velocity. Not
/// for free-slip walls, which have no v_shown.
///
/// Source: the continuity equation with the velocity of Morris, Fox and Zhu (1997) in the walls.
template <class Kernel = WendlandC2>
struct NoSlipContinuity {
    using effect = effects::continuity_equation;
    static constexpr bool between_fluid_and_other = true;
    struct Sweep { // a: fluid, b: wall or solid
        using reads = Fields<density, volume, velocity, no_slip_velocity>;
        using adds = Fields<density_rate>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            return a[density] * b[volume] * dot(a[velocity] - b[no_slip_velocity], ab.offset) * ab.gradient(Kernel{});
        }
    };
    using parts = Parts<Volume, Sweep>;
};

} // namespace imbibe
