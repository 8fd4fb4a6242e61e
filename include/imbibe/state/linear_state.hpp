// The linear equation of state: pressure in proportion to the change of density.
#pragma once

#include <imbibe/state/compression_energy.hpp>
#include <imbibe/state/wave_speed.hpp>

namespace imbibe {

/// p = c^2 (rho - rho_0), in Pa: the equation of Tait with gamma = 1.
///
/// For elastic solids, where rho_0 c^2 is the bulk modulus, and for liquids whose density hardly changes. In a solid
/// the limit of the time step is that of longitudinal waves, not of c.
///
/// Not for strong compression (a liquid gets stiffer, this does not) and not for gases.
///
/// Source: Gray, Monaghan and Swift (2001) for solids; the paper, Eq. (8) with gamma = 1.
struct LinearState {
    using reads = Fields<density>;
    using sets = Fields<pressure>;
    static constexpr bool in_packs = true;

    IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
        return sq(a.material.sound_speed) * (a[density] - a.material.density);
    }

    /// The density at a pressure p, Pa: rho = rho_0 + p/c^2, kg/m^3.
    static double density_at(const auto& material, double p) { return material.density + p / sq(material.sound_speed); }

    using reductions = Parts<CompressionEnergy>;

    static constexpr const char* limit_name = "sound";
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        return acoustic_time_step(material, in);
    }
};

} // namespace imbibe
