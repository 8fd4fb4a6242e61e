// A short-range repulsion between approaching fluid and solid particles.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/term.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace imbibe {

/// Coefficients of ModifiedRepulsion.
struct ModifiedRepulsionParameters {
    /// U, m/s: a pair that approaches with this speed along its line of centres is stopped as its particles touch. Take
    /// about the greatest speed of the impact; if the repulsion alone must bear a pressure p, ten to twenty times
    /// sqrt(p/rho).
    double speed = 1;
    /// Range, in means of the two particle spacings; at most the support radius.
    double range = 1;
    /// Coefficient of restitution of a pair, 0 to 1: its speed of separation over that of approach. With 0 it acts on
    /// approach only; with 1 it is an elastic spring.
    double restitution = 0;

    /// Throws Error for a number out of range. @param where the phase or coupling in the message
    void check(std::string_view where) const {
        require_not_negative(speed, where, "ModifiedRepulsionParameters::speed", "m/s");
        require_not_negative(range, where, "ModifiedRepulsionParameters::range", "spacings");
        require(restitution >= 0 && restitution <= 1, where,
                ": ModifiedRepulsionParameters::restitution = ", restitution, "; it must be at least 0 and at most 1");
    }
};

/// dv_a/dt = sum_b m_b/(m_a + m_b) 3 U^2/(2 r_0) (1 - r/r_0)^2 s_ab x_ab/r for r < r_0, in m/s^2, with r = |x_ab|,
/// r_0 = `range` mean spacings, and s_ab = 1 while the pair approaches (v_ab . x_ab <= 0), else restitution^2.
///
/// A guard of couplings: keeps fluid and solid particles from passing each other, is zero while they are in order, and
/// dissipates the energy of an impact. It scales with the lighter of the two masses, so one U serves all masses. The
/// force of the pair is along the line of centres, equal and opposite, to the last bit where the masses are equal:
/// momentum and angular momentum are conserved.
///
/// Use it beside a pressure coupling (VolumePressure with PressureExtrapolation, SurfaceNormalPressure), where it
/// changes nothing until particles come out of order; or as the only coupling of a rough contact. Alone, with U = 40
/// m/s, it bears half a metre of water on a soft plate (4.9 kPa); the plate sags 3 % less than under the same weight
/// without water, with a restitution of 0 as with 1.
///
/// As the only coupling, not for an accurate pressure on the solid: the force acts on single particles and the gap
/// depends on U. Not conservative for restitution below 1, by intent.
///
/// Source: own form. That a repulsion between fluid and solid be limited to close pairs is the idea of Amini, Emdad and
/// Farid (2011), whose formula it is not; a spring that unloads with restitution^2 of its force: Walton and Braun
/// (1986), for grains.
struct ModifiedRepulsion {
    using Parameters = ModifiedRepulsionParameters;
    using reads = Fields<mass, velocity>;
    using adds = Fields<acceleration>;
    Parameters parameters{};

    IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        using T = std::remove_cvref_t<decltype(ab.distance)>;
        const double spacings = parameters.range * 0.5 * (a.material.spacing + b.material.spacing);
        const T reach = min(ab.support_radius, T(max(spacings, 1e-30)));
        const T depth = positive_part(1 - ab.distance / reach);
        const auto parting = dot(a[velocity] - b[velocity], ab.offset) > T(0);
        const T share = select(parting, T(sq(parameters.restitution)), T(1));
        const T strength = T(1.5 * sq(parameters.speed)) * sq(depth) * share / reach;
        return along(ab, b[mass] / (a[mass] + b[mass]) * strength * ab.inverse_distance());
    }

    static constexpr const char* limit_name = "repulsion";
    /// Its limit depends on the nearest pair (TimeStepInput::nearest).
    static constexpr bool limit_by_nearest = true;
    /// 2 r_0/(U sqrt(3 d)), s: 2 over the frequency of a pair that is d r_0 within the range; at most r_0/v, the time
    /// in which a particle crosses it. d is the depth, at most 1, that the nearest pair reaches with the sum v of the
    /// greatest speeds of the two phases: d^3 = d_0^3 + (v/U)^2. Infinite if nothing moves and nothing is in reach.
    static double time_step_limit(const auto&, const auto&, const TimeStepInput& in, const Parameters& parameters) {
        const double reach = std::min(parameters.range * 0.5 * (in.spacing + in.other_spacing), in.support_radius);
        if (!(parameters.speed > 0 && reach > 0))
            return std::numeric_limits<double>::infinity();
        const double fastest = in.max_speed + in.other_max_speed;
        const double depth_now = in.nearest < reach ? 1 - in.nearest / reach : 0.0;
        const double depth = std::min(std::cbrt(power<3>(depth_now) + sq(fastest / parameters.speed)), 1.0);
        return reach / std::max(0.5 * std::sqrt(3 * depth) * parameters.speed, fastest);
    }
    /// The limit within one phase, for pairs of any depth, s: r_0/max(sqrt(3) U/2, 2 v) times the lesser of 1 and (1.25
    /// spacings/r_0)^(dim/2), KernelRepulsion's factor for the number of particles in reach.
    static double time_step_limit(const auto&, const TimeStepInput& in, const Parameters& parameters) {
        const double reach = std::min(parameters.range * in.spacing, in.support_radius);
        if (!(parameters.speed > 0 && reach > 0))
            return std::numeric_limits<double>::infinity();
        const double many = std::pow(std::min(1.0, 1.25 * in.spacing / reach), 0.5 * in.dimension);
        return many * reach / std::max(0.5 * std::sqrt(3.0) * parameters.speed, 2 * in.max_speed);
    }
};

} // namespace imbibe
