// Particle shifting: moves the particles of a fluid slightly from crowded to sparse regions.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/term.hpp>
#include <imbibe/fluid/surface_indicator.hpp>
#include <imbibe/kernels/wendland.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace imbibe {

/// sum_b V_b (1 + R (W_ab/W(spacing))^4) grad_a W_ab, 1/m: points to where particles are crowded. R is 0.2 in
/// ParticleShifting and 0 in StrainShifting.
struct ConcentrationGradient : Field<Rank::vector> {
    static constexpr std::string_view name = "concentration_gradient", unit = "1/m";
};
inline constexpr ConcentrationGradient concentration_gradient{};

/// sum_b V_b (x_b - x_a).grad_a W_ab / dim, without unit: 1 inside, about 0.65 at a free surface, 0 alone.
struct PositionDivergence : Field<Rank::scalar> {
    static constexpr std::string_view name = "position_divergence", unit = "1";
};
inline constexpr PositionDivergence position_divergence{};

/// sum_b s_b W_ab/W(spacing), without unit, with the surface indicator s: how near the free surface is.
struct SurfaceNearness : Field<Rank::scalar> {
    static constexpr std::string_view name = "surface_nearness", unit = "1";
};
inline constexpr SurfaceNearness surface_nearness{};

/// Coefficients of ParticleShifting.
struct ParticleShiftingParameters {
    /// Strength: shifting velocity over speed times H times the gradient of concentration. 1 to 2 is usual.
    double strength = 2;
    /// The greatest shifting velocity as a share of the particle's own speed.
    double most = 0.25;
    /// The speed used where a particle's own is less, m/s.
    double least_speed = 0;
    /// The farthest a particle is shifted in one step, over H^3/spacing times the gradient of concentration. On a
    /// square lattice no wave of places overshoots and grows with up to 0.038 to 0.043 (WendlandC2 with supports of 2.6
    /// to 4 spacings), 0.049 and more (CubicSpline, 3 to 4), 0.019 to 0.031 (WendlandC4 and QuinticSpline, 2.6 to 4):
    /// give the last two 0.018 where long steps make use of it. Beyond, particles go to and fro, within the bound of
    /// `most`.
    double most_in_a_step = 0.035;
    /// A particle is at a free surface where its position divergence is below `surface_below`, and inside where it is
    /// above `inside_above`; a straight ramp between the two.
    double surface_below = 0.75, inside_above = 0.85;

    /// Throws Error for a number out of range. @param where the phase in the message
    void check(std::string_view where) const {
        require_not_negative(strength, where, "ParticleShiftingParameters::strength", "");
        require_not_negative(most, where, "ParticleShiftingParameters::most", "");
        require_not_negative(least_speed, where, "ParticleShiftingParameters::least_speed", "m/s");
        require(std::isfinite(most_in_a_step) && most_in_a_step > 0, where,
                ": ParticleShiftingParameters::most_in_a_step = ", most_in_a_step,
                "; it must be finite and above 0, usually 0.035");
        require(inside_above > surface_below, where, ": ParticleShiftingParameters::inside_above = ", inside_above,
                "; it must be above surface_below, ", surface_below);
    }
};

/// The sums over neighbours of ParticleShifting: the gradient of concentration, with R = 0.2, and the position
/// divergence. A part of ParticleShifting, and a term of its own for couplings: `Into<Water, ShiftingNeighbours<>>`
/// makes the particles of a wall or a solid count as neighbours. Without it a wall is taken for a free surface, beside
/// which nothing is shifted.
///
/// Not where the density follows VolumeContinuity or Continuity: particles that are continuously shifted off a wall
/// make the fluid flow towards it, and its density rises, in a closed cavity by 20 % until t = 15, while the flow loses
/// half of its speed. With SummationDensity, with SummationRelaxation beside the continuity equation, and with
/// corrected gradients, use it (docs/validation.md, cavity).
///
/// Source: Monaghan (2000) for the factor; see ParticleShifting.
template <class Kernel = WendlandC2>
struct ShiftingNeighbours {
    using reads = Fields<mass, density>;
    using adds = Fields<concentration_gradient, position_divergence>;

    IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        constexpr int dim = std::remove_cvref_t<decltype(a)>::dimension;
        const auto ratio = ab.relative_value(Kernel{}, a.material.spacing);
        const auto weight = b[mass] / b[density] * ab.gradient(Kernel{});
        return values(along(ab, weight * (1 + 0.2 * sq(sq(ratio)))), -(weight * squared_norm(ab.offset)) * (1.0 / dim));
    }
};

/// transport_correction = - (1 - s) g_a min(|v_a| strength H, |v_a| most/|g_a|, 0.035 H^3/(spacing dt)), in m/s, with
/// the gradient of concentration
///
///     g_a = sum_b V_b (1 + 0.2 (W_ab/W(spacing))^4) grad_a W_ab
///
/// and s between 0 inside and 1 at and near a free surface. Particles are moved with v + transport_correction; their
/// momentum is untouched. The last bound, `most_in_a_step`, is there for long steps dt: shifting is a diffusion of
/// positions, of which explicit steps bear so much and no more. The steps of sound, at the CFL number 0.75 and a tenth
/// of its speed, come to it with a strength of 2, at 0.4 to half of it. MidpointRungeKutta and PredictorCorrector,
/// which do not tell their terms how long a step is, go without; with Leapfrog the length is that of the step before.
///
/// Keeps particles evenly spread where they would line up along streamlines, and closes the voids that open where the
/// pressure is negative. Off at the free surface, so that it does not creep: s_a = min(sum_b chi_b W_ab/W(spacing), 1),
/// where chi is 1 for particles whose position divergence, sum_b V_b (x_b - x_a).grad W_ab, is below 0.75 dim, and 0
/// above 0.85 dim. So it is off in the first two layers, and weaker in the third.
///
/// The shifted particle takes its velocity and density along. Mass and momentum are conserved exactly; energy and
/// angular momentum are not, with an error of the order of |delta v|/|v| times the change of velocity over H. So not
/// for long runs without viscosity; for accurate velocities in vortices of low viscosity, use TransportAdvection beside
/// it.
/// Not where things are at rest or where only differences of velocity count: the speed is that in the frame of the
/// scene. Not beside XsphTransport. In a flow between walls see ShiftingNeighbours.
/// Not from a perfect lattice with the coefficients as they are: it has no gradient of concentration until its rows
/// collapse. Jitter it by a few per cent of a spacing (geometry/jitter.hpp), or take strength = 4 and the speed of the
/// flow for least_speed: a Taylor-Green vortex at Re = 100 is then right to 1 %, else it loses a third of its speed.
///
/// Source: Lind, Xu, Stansby and Rogers (2012) for the gradient of concentration; Skillen et al. (2013) for the speed
/// in its factor; Oger et al. (2016) for a velocity with a bound; Monaghan (2000) for the factor against pairing; Lee
/// et al. (2008) for the position divergence, with 1.5 in 2D. That the neighbours of a surface are left alone is own.
template <class Kernel = WendlandC2>
struct ParticleShifting {
    using Parameters = ParticleShiftingParameters;

    struct Detect {
        using reads = Fields<position_divergence>;
        using sets = Fields<surface_indicator>;
        static constexpr bool in_packs = true;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            using T = typename std::remove_cvref_t<decltype(a)>::Scalar;
            const double ramp = parameters.inside_above - parameters.surface_below;
            return min(positive_part((parameters.inside_above - a[position_divergence]) / ramp), T(1));
        }
    };
    struct Approach {
        using reads = Fields<surface_indicator>;
        using adds = Fields<surface_nearness>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            return b[surface_indicator] * ab.relative_value(Kernel{}, a.material.spacing);
        }
    };
    struct Shift {
        using reads = Fields<velocity, concentration_gradient, surface_nearness>;
        using sets = Fields<transport_correction>;
        static constexpr bool in_packs = true;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            using T = typename std::remove_cvref_t<decltype(a)>::Scalar;
            const double H = a.material.support_radius;
            const auto g = a[concentration_gradient];
            const T inside = positive_part(T(1) - a[surface_nearness]);
            const T speed = max(sqrt(squared_norm(a[velocity])), T(parameters.least_speed));
            const T bound = parameters.most / max(sqrt(squared_norm(g)), T(1e-30));
            T diffusivity = speed * min(T(parameters.strength * H), bound); // m^2/s
            if (a.time_step > 0)
                diffusivity =
                    min(diffusivity, T(parameters.most_in_a_step * H * H * H / (a.material.spacing * a.time_step)));
            return -(inside * diffusivity) * g;
        }
    };
    using parts = Parts<ShiftingNeighbours<Kernel>, Detect, Approach, Shift>;

    static constexpr const char* advection_limit_name = "particle shifting";
    /// 2.5 most_in_a_step H^2/(spacing strength v), s, with the greatest speed v, at least `least_speed`: for the long
    /// steps of DualStepping, if it is evaluated in those. At a CFL number of 0.4 that is as long as steps can be
    /// before `most_in_a_step` shifts particles by less than `strength` asks for; longer ones, such as those of the
    /// default of 0.75, leave less order among them. Steps that sound limits are shorter than that, with a strength of 2, as long as v is below a sixth of its
    /// speed.
    static double advection_limit(const auto& material, const TimeStepInput& in, const Parameters& parameters) {
        const double speed = parameters.strength * std::max(in.fastest, parameters.least_speed);
        return speed > 0 ? 2.5 * parameters.most_in_a_step * material.support_radius * material.support_radius /
                               (in.spacing * speed)
                         : std::numeric_limits<double>::infinity();
    }
};

} // namespace imbibe
