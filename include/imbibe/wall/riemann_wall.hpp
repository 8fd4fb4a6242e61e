// One-sided Riemann problems between a fluid and a wall or a solid: each fluid particle meets its own mirrored state.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/fluid/riemann.hpp>
#include <imbibe/state/wave_speed.hpp>

namespace imbibe {

/// sum_w V_w grad_f W_fw, 1/m: from a fluid particle into the walls around it, zero away from walls.
struct WallDirection : Field<Rank::vector> {
    static constexpr std::string_view name = "wall_direction", unit = "1/m";
};
inline constexpr WallDirection wall_direction{};

/// n_f = sum_w V_w grad_f W_fw, in 1/m, for a particle f of the fluid and the particles w of a wall or a solid: the
/// direction in which the wall is.
///
/// Goes into the fluid, together with RiemannWallPressure: `Coupling<Water, Wall, Into<Water, RiemannWallNormal<>>,
/// ...>`. The normal is that of the wall as seen from the fluid particle, not one of a wall particle. It needs only
/// positions and volumes of the wall, so it is right in corners (the direction between the two faces), on solids that
/// turn and bend, and for any interior of the wall. It costs no sweep of its own beside a continuity equation.
///
/// Not between two walls of equal distance (a slit one particle wide), where the two cancel.
///
/// Source: own; normals from sums of kernel gradients are as old as Randles and Libersky (1996).
template <class Kernel = WendlandC2>
struct RiemannWallNormal {
    using reads = Fields<mass, density>;
    using adds = Fields<wall_direction>;

    IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
        return along(ab, b[mass] / b[density] * ab.gradient(Kernel{}));
    }
};

/// Coefficients of RiemannWallPressure.
struct RiemannWallPressureParameters {
    /// How soon the dissipation sets in; see RiemannPressureParameters.
    double eta = 3;
    /// May the wall pull? If not, p* is clipped at zero, and the fluid can leave it. Only together with DensityFloor:
    /// clipping alone lets the fluid swell. Free-surface flow is better without: in a dam break with suction the energy
    /// grows by 1 % while the water climbs the far wall, and without it never grows.
    bool suction = true;

    /// Throws Error for a number out of range. @param where the phase or coupling in the message
    void check(std::string_view where) const {
        require_not_negative(eta, where, "RiemannWallPressureParameters::eta", "");
    }
};

/// dv_f/dt = - 2/m_f sum_w V_f V_w p* grad_f W_fw, in m/s^2, for a particle f of the fluid and the particles w of a
/// wall or a solid; on a solid the opposite, pair by pair. The wall shows the fluid's own state, mirrored:
///
///     p_L = p_f, U_L = n.v_f;   p_R = p_f + rho_f g.(x_w - x_f), U_R = -U_L + 2 n.v_w;
///     p* = (p_L + p_R)/2 + beta rho_0 c (U_L - U_R)/2 = p_f + rho_f g.(x_w - x_f)/2 + beta rho_0 c n.(v_f - v_w),
///
/// with the unit normal n into the wall, from RiemannWallNormal, beta = min(eta max(U_L - U_R, 0)/c, 1), and rho_0 c of
/// the fluid. Only what moves towards the wall is damped, not what slides along it: that is why normals are used and
/// not lines of centres, which would act as friction. The force of the pair is along the line of centres, equal and
/// opposite, to the last bit where the masses are equal.
///
/// Use it with RiemannWallContinuity, which does as much work: `Coupling<Water, Wall, Into<Water, RiemannWallNormal<>>,
/// RiemannWallPressure<>, Into<Water, RiemannWallContinuity<>>>`. Works for any fluid with a pressure, with or without
/// RiemannPressure. Nothing is averaged over the fluid: each side of a thin plate feels its own fluid's pressure.
///
/// Not with walls of one layer: with 3 spacings of support a dam break is the same with 2 layers as with 3, and runs
/// through the floor with 1. Not for a solid that accelerates as fast as the water falls: of the source's g - dv_w/dt
/// only g is used. Free-slip: for a no-slip wall add NoSlipVelocity and NoSlipViscosity.
///
/// Source: Zhang, Hu and Adams (2017), the section on the wall boundary condition; the normal is taken in the fluid.
template <class Kernel = WendlandC2>
struct RiemannWallPressure {
    using effect = effects::pressure_force;
    static constexpr bool between_fluid_and_other = true;
    using Parameters = RiemannWallPressureParameters;

    struct Push {
        using reads = Fields<mass, volume, density, velocity, pressure, wall_direction>;
        using adds = Fields<acceleration>;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const auto per_mass = 1 / a[mass];
            const auto force = 2 * (a[volume] * b[volume] * ab.gradient(Kernel{}) * per_mass);
            if constexpr (detail::is_fluid<typename std::remove_cvref_t<decltype(a)>::Material>)
                return along(ab, -(force * pressure_at_wall(a, b, -dot(ab.gravity(), ab.offset))));
            else
                return along(ab, -(force * pressure_at_wall(b, a, dot(ab.gravity(), ab.offset))));
        }

    private:
        // @param depth g.(x_w - x_f)
        template <class T>
        IMBIBE_INLINE constexpr T pressure_at_wall(const auto& fluid, const auto& wall, T depth) const {
            const double c = fluid.material.sound_speed, Z = detail::impedance(fluid.material);
            const auto n = fluid[wall_direction];
            const T least = T(1e-12); // 1/m: no wall, no direction
            const T approach = 2 * dot(fluid[velocity] - wall[velocity], n) / max(sqrt(squared_norm(n)), least);
            const T beta = detail::riemann_limiter(approach, c, parameters.eta);
            const T p = fluid[pressure] + T(0.5) * fluid[density] * depth + (0.5 * Z) * beta * approach;
            return parameters.suction ? p : positive_part(p);
        }
    };
    using parts = Parts<Volume, Push>;

    static constexpr const char* limit_name = "Riemann dissipation at the wall";
    /// 0.55 H/(beta c), s, with the c of the fluid and beta of a particle that meets its own image: 2 over the rate 2
    /// beta c |sum_w V_w grad W| at which the wall slows it down, five sixths of it. At the surface of a wall the sum
    /// is 1.5/H with WendlandC2, and up to a sixth more where the wall is a lattice of 2 to 3 spacings a support.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in,
                                  const Parameters& parameters) {
        using A = std::remove_cvref_t<decltype(material_a)>;
        const double c = detail::is_fluid<A> ? material_a.sound_speed : material_b.sound_speed;
        const double dissipating = std::min(2 * parameters.eta * (in.max_speed + in.other_max_speed), c); // beta c
        return dissipating > 0 ? 0.55 * in.support_radius / dissipating : std::numeric_limits<double>::infinity();
    }
};

/// drho_f/dt = 2 rho_f sum_w V_w (v_f - v_w) . grad_f W_fw, in kg/m^3/s: RiemannContinuity with the mirrored state of
/// RiemannWallPressure, for which U* is the wall's own velocity at rest and in motion.
///
/// Goes into the fluid: `Into<Water, RiemannWallContinuity<>>`. It needs no normal: summed over the wall, only the
/// velocity along wall_direction is left. Twice VolumeContinuity with a wall, because the mirrored velocity changes
/// across the wall's surface as much as the fluid's own does in front of it.
///
/// Not beside VolumePressure and PressureExtrapolation: their work is that of VolumeContinuity.
///
/// Source: Zhang, Hu and Adams (2017), with U* without the hydrostatic part of p_L - p_R, so that still water is still.
template <class Kernel = WendlandC2>
struct RiemannWallContinuity {
    using effect = effects::continuity_equation;
    using reads = Fields<mass, density, velocity>;
    using adds = Fields<density_rate>;

    IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        return 2 * a[density] * (b[mass] / b[density]) * dot(a[velocity] - b[velocity], ab.offset) *
               ab.gradient(Kernel{});
    }

    static constexpr const char* limit_name = "pressure between phases";
    /// That of interface_time_step, s: both this and RiemannWallPressure are twice what they are between two fluids.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in) {
        return interface_time_step(material_a, material_b, in, 4);
    }
};

} // namespace imbibe
