// The fastest wave of a material: what an equation of state asks of the time step.
#pragma once

#include <imbibe/core/term.hpp>

#include <algorithm>

namespace imbibe {

/// The speed of the fastest wave that a material carries, m/s: longitudinal waves in a solid,
/// sqrt((K + 4G/3)/rho) (also in 2D, which is plane strain), sound in anything else.
double fastest_wave_speed(const auto& material) {
    if constexpr (requires { material.longitudinal_wave_speed(); })
        return material.longitudinal_wave_speed();
    else
        return material.sound_speed;
}

/// max(spacing, 0.6 H)/(c + v), s, with the speed c of the fastest wave and v of the fastest particle: the
/// Courant-Friedrichs-Lewy limit of a compressible material. The solver multiplies it with the CFL number.
///
/// Rates of densities and forces of pressure are two sums over kernel gradients, one the negative transpose of the
/// other, so that no wave is faster than c times the largest |sum_b V_b grad W_ab sin(k.x_ab)|, and a symplectic step is
/// stable below 2 over that frequency: on square and cubic lattices with two or more spacings a support 0.9 H/c with
/// WendlandC2, the cubic spline and Spiky, 0.76 H/c with WendlandC4 and the quintic spline, 0.68 H/c with WendlandC6.
/// Wider supports see no wave as short as a spacing. 0.6 leaves room for disorder and viscosity. Below 1.7 spacings a
/// support a lattice would allow much more, but particles that come nearer to each other than in a lattice would not.
double acoustic_time_step(const auto& material, const TimeStepInput& in) {
    return std::max(in.spacing, 0.6 * in.support_radius) / (fastest_wave_speed(material) + in.max_speed);
}

} // namespace imbibe
