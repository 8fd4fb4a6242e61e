// The fastest wave of a material: what an equation of state asks of the time step.
#pragma once

#include <imbibe/core/term.hpp>

namespace imbibe {

/// The speed of the fastest wave that a material carries, m/s: longitudinal waves in a solid,
/// sqrt((K + 4G/3)/rho) (also in 2D, which is plane strain), sound in anything else.
double fastest_wave_speed(const auto& material) {
    if constexpr (requires { material.longitudinal_wave_speed(); })
        return material.longitudinal_wave_speed();
    else
        return material.sound_speed;
}

/// The time in which the fastest wave and the fastest particle together cross one particle spacing, s: the
/// Courant-Friedrichs-Lewy limit of a compressible material. The solver multiplies it with the CFL number.
double acoustic_time_step(const auto& material, const TimeStepInput& in) {
    return in.spacing / (fastest_wave_speed(material) + in.max_speed);
}

} // namespace imbibe
