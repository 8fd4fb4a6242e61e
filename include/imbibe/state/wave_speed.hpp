// The fastest wave of a material, and the time step limits that follow from it.
#pragma once

#include <imbibe/core/term.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace imbibe {

/// The speed of the fastest wave that a material carries, m/s: longitudinal waves in a solid,
/// sqrt((K + 4G/3)/rho) (also in 2D, which is plane strain), sound in anything else.
double fastest_wave_speed(const auto& material) {
    if constexpr (requires { material.longitudinal_wave_speed(); })
        return material.longitudinal_wave_speed();
    else
        return material.sound_speed;
}

namespace detail {
// The mean speed of sound of a pair, m/s. A wall takes that of the other phase, because its own means nothing.
constexpr double mean_sound_speed(const auto& material_a, const auto& material_b) {
    if constexpr (!std::remove_cvref_t<decltype(material_a)>::moves)
        return material_b.sound_speed;
    else if constexpr (!std::remove_cvref_t<decltype(material_b)>::moves)
        return material_a.sound_speed;
    else
        return 0.5 * (material_a.sound_speed + material_b.sound_speed);
}
} // namespace detail

/// max(spacing, 0.6 H)/(c + v), s, for a wave of speed c, m/s, and the speed v of the fastest particle: see below.
inline double acoustic_time_step(double wave_speed, const TimeStepInput& in) {
    return std::max(in.spacing, 0.6 * in.support_radius) / (wave_speed + in.max_speed);
}
/// max(spacing, 0.6 H)/(c + v), s, with the speed c of the fastest wave and v of the fastest particle: the
/// Courant-Friedrichs-Lewy limit of a compressible material. The solver multiplies it with the CFL number.
///
/// Rates of densities and forces of pressure are two sums over kernel gradients, one the negative transpose of the
/// other, so the highest frequency is c times the largest |sum_b V_b grad W_ab sin(k.x_ab)|, and a symplectic step is
/// stable below 2 over that frequency. On square and cubic lattices with two or more spacings a support this is 0.9 H/c
/// with WendlandC2, the cubic spline and Spiky, 0.76 H/c with WendlandC4 and the quintic spline, 0.68 H/c with
/// WendlandC6. Wider supports do not resolve waves as short as a spacing. 0.6 leaves room for disorder and viscosity.
/// Below 1.7 spacings a support a lattice would allow much more, but particles closer than in a lattice would not.
double acoustic_time_step(const auto& material, const TimeStepInput& in) {
    return acoustic_time_step(fastest_wave_speed(material), in);
}

/// max(spacing, 0.6 H)/(sqrt(0.18 n K/rho) + v), s: the limit where a phase of density rho meets a fluid of stiffness K
/// = rho_f c_f^2, whose pressure it changes by its motion and by which it is pushed. The lesser value of both roles; v
/// is the greatest speed of both. n is 1 between two fluids and `at_solid` at a solid, whose pressure is the fluid's:
/// the fluid pushes it twice as hard.
///
/// It is shorter than the limits of the two phases alone only if one of them is light: a gas beside a liquid with the
/// same speed of sound, or a soft solid of less than a third of the water's density. 0.18 is from the highest
/// frequencies of two layers, and of one particle and of three by three (by three) within the other fluid, on lattices
/// with supports of 1.5 to 3 spacings, with WendlandC2 and the cubic spline, the heavier fluid 10 to 1000 times as
/// stiff. How far steps may exceed it: the rows "pressure between phases" of docs/stability_tables.md.
double interface_time_step(const auto& material_a, const auto& material_b, const TimeStepInput& in,
                           double at_solid = 2) {
    using A = std::remove_cvref_t<decltype(material_a)>;
    using B = std::remove_cvref_t<decltype(material_b)>;
    double squared_speed = 0; // K/rho
    if constexpr (detail::is_fluid<A> && B::moves)
        squared_speed = material_a.density * sq(material_a.sound_speed) / material_b.density;
    if constexpr (detail::is_fluid<B> && A::moves)
        squared_speed = std::max(squared_speed, material_b.density * sq(material_b.sound_speed) / material_a.density);
    if (!(squared_speed > 0))
        return std::numeric_limits<double>::infinity();
    const double n = detail::is_fluid<A> && detail::is_fluid<B> ? 1 : at_solid;
    return std::max(std::min(in.spacing, in.other_spacing), 0.6 * in.support_radius) /
           (std::sqrt(0.18 * n * squared_speed) + std::max(in.max_speed, in.other_max_speed));
}

/// max(least spacing, 0.6 H)/(0.4 c rho_heavy/rho_light + v), s, with the greatest speed of sound c of the fluids (of
/// both phases if neither is one) and v of the particles: the limit on steps of two phases that push each other by
/// SymmetricPressure and count each other's masses by Continuity. These forms weight a neighbour with its mass where
/// VolumePressure uses its volume, so the stiffness of the light side grows with the ratio of the densities, not its
/// root. tests/monitor/test_longest_stable_step.cpp asserts how much of it is stable.
double mass_weighted_interface_time_step(const auto& material_a, const auto& material_b, const TimeStepInput& in) {
    using A = std::remove_cvref_t<decltype(material_a)>;
    using B = std::remove_cvref_t<decltype(material_b)>;
    if constexpr (!A::moves || !B::moves)
        return std::numeric_limits<double>::infinity();
    double c = std::max(material_a.sound_speed, material_b.sound_speed);
    if constexpr (detail::is_fluid<A> != detail::is_fluid<B>)
        c = detail::is_fluid<A> ? material_a.sound_speed : material_b.sound_speed;
    const double ratio = std::max(material_a.density / material_b.density, material_b.density / material_a.density);
    return std::max(std::min(in.spacing, in.other_spacing), 0.6 * in.support_radius) /
           (0.4 * c * ratio + std::max(in.max_speed, in.other_max_speed));
}

} // namespace imbibe
