// A floor under the density: water that is pulled apart opens up instead of clumping.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/term.hpp>

namespace imbibe {

/// Coefficients of DensityFloor.
struct DensityFloorParameters {
    /// How fast missing density is restored, in units of c/spacing. 1 restores it within about the time that sound
    /// takes to cross a particle; below about 0.1 tension is hardly relieved.
    double rate = 1;
    /// How far below the reference density the floor lies, as a share of it: the liquid bears a tension of slack rho_0
    /// c^2.
    double slack = 0;

    /// Throws Error for a number out of range. @param where the phase or coupling in the message
    void check(std::string_view where) const {
        require_not_negative(rate, where, "DensityFloorParameters::rate", "");
        require(slack >= 0 && slack < 1, where, ": DensityFloorParameters::slack = ", slack,
                " (a share of the density at rest); it must be at least 0 and below 1, usually 0 or 1e-3");
    }
};

/// drho_a/dt += rate c/spacing max((1 - slack) rho_0 - rho_a, 0), in kg/m^3/s.
///
/// Water in a jet or at a corner that is pulled apart would come under tension, and particles under tension clump in
/// pairs. Real water opens a void instead, at a pressure that is zero on the scale of the flow. This term brings the
/// density of a particle below the reference density back to it within the time that sound takes to cross a particle:
/// the pressure then does not fall below about -rho_0 c (slack c + spacing div v).
///
/// Use it together with walls that do not pull (PressureExtrapolation with `suction = false`; with a slack also
/// VolumePressure with Tension::none there, or single drops stick to them). Never use those walls without this floor:
/// the water then swells (down to half its density in the scene of the paper).
///
/// Not for flows that need tension or suction (a siphon, a wake in a closed channel without background pressure): it
/// lets voids open, unless the slack bears the tension. Mass is conserved; the volume m/rho of water that opens and
/// closes again is conserved only approximately.
///
/// Source: own; a floor on the density at free surfaces is common practice, here in the form of a rate, so that it
/// needs nothing from the integrator.
struct DensityFloor {
    using Parameters = DensityFloorParameters;
    using reads = Fields<density>;
    using adds = Fields<density_rate>;
    Parameters parameters{};

    IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
        const auto& fluid = a.material;
        const double per_time = parameters.rate * fluid.sound_speed / max(fluid.spacing, 1e-30);
        return per_time * positive_part((1 - parameters.slack) * fluid.density - a[density]);
    }

    static constexpr const char* limit_name = "density floor";
    /// 2 spacing/(rate c), s: after a longer step the density would be further above the floor than it was below. That
    /// would not be unstable, but noisy.
    static double time_step_limit(const auto& material, const TimeStepInput& in, const Parameters& parameters) {
        return 2 * in.spacing / max(parameters.rate * material.sound_speed, 1e-30);
    }
};

} // namespace imbibe
