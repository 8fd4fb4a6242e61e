// The low-dissipation Riemann scheme of a weakly compressible fluid: the pressure and velocity between two particles
// are those of the star region between the sound waves from either side.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/fluid/volume.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/state/wave_speed.hpp>

#include <algorithm>
#include <limits>

namespace imbibe {

/// p/Z, m/s, with the acoustic impedance Z = rho_0 c: what RiemannPressure prepares once per particle.
struct PressureOverImpedance : Field<Rank::scalar> {
    static constexpr std::string_view name = "pressure_over_impedance", unit = "m/s";
};
inline constexpr PressureOverImpedance pressure_over_impedance{};

namespace detail {

// rho_0 c, kg/(m^2 s). Positive also for materials that are not given yet (-1), with which the compiler tries a term
// out, so that their sum is not zero.
constexpr double impedance(const auto& material) {
    const double Z = material.density * material.sound_speed;
    return Z < 0 ? -Z : Z;
}

// beta = min(eta max(U_L - U_R, 0)/c, 1).
template <class T>
IMBIBE_INLINE constexpr T riemann_limiter(T approach, double c, double eta) {
    return min(positive_part(approach) * (eta / c), T(1));
}

// 2 over the fastest rate of decay of du_a/dt = -c sum_b V_b |grad W_ab| (u_a - u_b) on square and cubic lattices of 2
// to 4 spacings a support, with WendlandC2: 5.6 c/H in 2D, 6.6 c/H in 3D; five sixths of it, for disorder.
inline double riemann_limit(double c, const TimeStepInput& in) {
    const double share = in.dimension == 2 ? 0.3 : 0.255;
    return c > 0 ? share * in.support_radius / c : std::numeric_limits<double>::infinity();
}
// The same where only the difference along the line of centres counts: 3.8 c/H in 2D, 3.5 c/H in 3D.
inline double central_riemann_limit(double c, const TimeStepInput& in) {
    return c > 0 ? 0.48 * in.support_radius / c : std::numeric_limits<double>::infinity();
}

} // namespace detail

/// Coefficients of RiemannPressure.
struct RiemannPressureParameters {
    /// Onset of the dissipation, without unit: it is full where two particles approach at c/eta or more, and falls with
    /// the speed of approach below. 0: none, the pressure is the mean of the two.
    double eta = 3;

    /// Throws Error for a number out of range. @param where the phase or coupling in the message
    void check(std::string_view where) const { require_not_negative(eta, where, "RiemannPressureParameters::eta", ""); }
};

/// dv_a/dt = - 2/m_a sum_b V_a V_b p* grad_a W_ab, in m/s^2, with the pressure between the two waves of a pair,
///
///     p* = (Z_b p_a + Z_a p_b + beta Z_a Z_b (U_a - U_b)) / (Z_a + Z_b),   beta = min(eta max(U_a - U_b, 0)/c, 1),
///
/// the velocities U along the line of centres from a to b (U_a - U_b > 0: they approach), the impedances Z = rho_0 c of
/// the materials and their mean sound speed c. Within one fluid p* is the mean pressure plus beta rho_0 c/2 times the
/// speed of approach.
///
/// Use it with RiemannContinuity in place of VolumePressure, VolumeContinuity, DensityDiffusion and MonaghanViscosity:
/// it has no coefficient that depends on the flow. For violent free-surface flow, impact, sound waves; also across a
/// density jump. The force of the pair is along the line of centres, equal and opposite, to the last bit where the
/// masses are equal. beta makes the dissipation second order in the speed of approach: little in smooth flow, that of
/// the full Riemann problem in an impact.
///
/// It dissipates too much in smooth flow on few particles: in a Taylor-Green vortex at Re = 50, 16 particles across,
/// with ParticleShifting, it takes 15 % of the energy that viscosity leaves until t = 0.25; with eta = 0 nothing, to 3
/// % (tests/solver/test_closed_box.cpp). Without ParticleShifting, particles without a free surface become disordered
/// there.
///
/// Not a physical viscosity: add MorrisViscosity or ClearyViscosity for that. Not without a remedy against clumping
/// where the pressure is negative (DensityFloor, ParticleShifting). Not for a wall: see RiemannWallPressure.
///
/// Source: Zhang, Hu and Adams (2017), there with rho_a + rho_b for 2 rho_0, which is the same to a per cent in a
/// weakly compressible fluid; with two impedances: Rezavand, Zhang and Hu (2020).
template <class Kernel = WendlandC2>
struct RiemannPressure {
    using effect = effects::pressure_force;
    static constexpr bool between_fluids = true;
    using Parameters = RiemannPressureParameters;

    struct Prepare {
        using reads = Fields<pressure>;
        using sets = Fields<pressure_over_impedance>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            return a[pressure] / detail::impedance(a.material);
        }
    };
    struct Push {
        using reads = Fields<mass, volume, velocity, pressure_over_impedance>;
        using adds = Fields<acceleration>;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const double Z_a = detail::impedance(a.material), Z_b = detail::impedance(b.material);
            const double c = detail::mean_sound_speed(a.material, b.material);
            const auto approach = -dot(a[velocity] - b[velocity], ab.offset) * ab.inverse_distance();
            const auto beta = detail::riemann_limiter(approach, c, parameters.eta);
            // p* in this form, p_a/Z_a + p_b/Z_b, is the same from both sides to the last bit.
            const auto p =
                (a[pressure_over_impedance] + b[pressure_over_impedance] + beta * approach) * (Z_a * Z_b / (Z_a + Z_b));
            const auto per_mass = 1 / a[mass];
            return along(ab, -(2 * (a[volume] * b[volume] * p * ab.gradient(Kernel{}) * per_mass)));
        }
    };
    using parts = Parts<Volume, Prepare, Push>;

    static constexpr const char* limit_name = "Riemann dissipation";
    /// 0.48 H/(beta c), s, with beta of two particles that meet at twice the greatest speed.
    static double time_step_limit(const auto& material, const TimeStepInput& in, const Parameters& parameters) {
        return time_step_limit(material, material, in, parameters);
    }
    /// The same between two phases.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in,
                                  const Parameters& parameters) {
        const double c = std::max(material_a.sound_speed, material_b.sound_speed);
        const double approach = in.max_speed + std::max(in.max_speed, in.other_max_speed);
        return detail::central_riemann_limit(std::min(parameters.eta * approach, c), in);
    }
};

/// drho_a/dt = 2 rho_a sum_b V_b (v_a - v*) . grad_a W_ab, in kg/m^3/s, with the velocity between the two waves of a
/// pair, along the line of centres from a to b,
///
///     U* = (Z_a U_a + Z_b U_b + p_a - p_b - (s rho)_ab g.(x_a - x_b)) / (Z_a + Z_b),
///
/// the impedances Z = rho_0 c, p = c^2 (rho - rho_0) and the mean (s rho)_ab of the two particles' densities times
/// their supported_share. Its first half is VolumeContinuity, its second half smooths the pressure as DensityDiffusion
/// does, with no coefficient to choose. The hydrostatic part is own: without it a column of water of 20 particles
/// swells until, after t sqrt(g/H) = 30, a fifth of its pressure is gone. It acts as far as the water is borne
/// (SupportedShare); without gravity, and in free fall, U* is that of the source.
///
/// Use it with RiemannPressure: the two conserve energy except for what p* and U* dissipate.
///
/// p is that of LinearState, for any equation of state: the density rate must not wait for the pressure of this step.
/// For a Tait fluid this makes an error of a few per cent, in the smoothing only.
/// Not towards a wall (see RiemannWallContinuity). It smooths more than DensityDiffusion with its usual delta: not for
/// sound waves resolved by few particles. In a tank that is accelerated sideways, pass the acceleration as part of
/// gravity (Solver::set_gravity).
///
/// Source: Zhang, Hu and Adams (2017); with two impedances: Rezavand, Zhang and Hu (2020); the hydrostatic part as in
/// Fourtakas et al. (2019), linearised, s is own.
template <class Kernel = WendlandC2>
struct RiemannContinuity {
    using effect = effects::continuity_equation;
    static constexpr bool between_fluids = true;
    using reads = Fields<mass, density, velocity, supported_share>;
    using adds = Fields<density_rate>;

    IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        const auto& fluid_a = a.material;
        const auto& fluid_b = b.material;
        const double Z_a = detail::impedance(fluid_a), Z_b = detail::impedance(fluid_b);
        const auto p_a = sq(fluid_a.sound_speed) * (a[density] - fluid_a.density);
        const auto p_b = sq(fluid_b.sound_speed) * (b[density] - fluid_b.density);
        const auto borne = a[density] * a[supported_share] + b[density] * b[supported_share];
        const auto excess = p_a - p_b - 0.5 * borne * dot(ab.gravity(), ab.offset);
        // (v_a - v*).grad W = (U_a - U*) e.x_ab F with e.x_ab = -|x_ab| and e.(v_a - v_b) = -(v_a - v_b).x_ab/|x_ab|
        const auto flux = Z_b * dot(a[velocity] - b[velocity], ab.offset) + excess * ab.distance;
        return (2 / (Z_a + Z_b)) * a[density] * (b[mass] / b[density]) * flux * ab.gradient(Kernel{});
    }

    static constexpr const char* limit_name = "Riemann smoothing of the density";
    /// 0.3 H/c in 2D, 0.255 H/c in 3D, s: five sixths of 2 over the fastest rate of decay, with WendlandC2 on lattices
    /// of 2 to 4 spacings a support.
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        return time_step_limit(material, material, in);
    }
    /// The same between two phases, with the greater sound speed.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in) {
        return detail::riemann_limit(std::max(material_a.sound_speed, material_b.sound_speed), in);
    }
};

} // namespace imbibe
