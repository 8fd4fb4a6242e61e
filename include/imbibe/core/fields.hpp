// The fields every SPH code knows. A term that needs a field of its own declares it beside itself.
#pragma once

#include <imbibe/core/field.hpp>

namespace imbibe {

/// Position in space, m.
struct Position : Field<Rank::vector> {
    static constexpr std::string_view name = "position", unit = "m";
    static constexpr bool given = true;
};
inline constexpr Position position{};

/// Velocity, m/s. Its rate is the acceleration.
struct Velocity : Field<Rank::vector> {
    static constexpr std::string_view name = "velocity", unit = "m/s";
    static constexpr std::string_view rate_name = "acceleration", rate_unit = "m/s^2";
    static constexpr bool given = true;
};
inline constexpr Velocity velocity{};
/// Acceleration, m/s^2: starts every step from the scene's gravity.
inline constexpr Rate<Velocity> acceleration{};
/// Share of a fluid particle's weight that its surroundings bear, without unit: 1 at rest, 0 in free fall, in general
/// (g - a).g/|g|^2 with the scene's gravity g and the acceleration a. It is a running mean over the time that sound
/// takes for 10 support radii, so that sound waves do not count; a particle that was in free fall follows at once, up
/// to 1. Zero before the first step and without gravity.
/// The solver keeps it for terms that read it, because the rates of a step can use only the accelerations of earlier
/// steps.
///
/// Source: own.
struct SupportedShare : Field<Rank::scalar> {
    static constexpr std::string_view name = "supported_share", unit = "1";
    static constexpr bool given = true;
};
inline constexpr SupportedShare supported_share{};

/// The share n of space that a fluid fills, without unit: 1, except in the pores of a skeleton. Its density is the mass
/// per total volume, n times the density of the fluid itself.
struct Porosity : Field<Rank::scalar> {
    static constexpr std::string_view name = "porosity", unit = "1";
    static constexpr bool shown = true;
};
inline constexpr Porosity porosity{};

/// How fast implicit drags slow a particle down against what surrounds it, 1/s: the sum of their coefficients over the
/// particle's mass.
struct DragRate : Field<Rank::scalar> {
    static constexpr std::string_view name = "drag_rate", unit = "1/s";
};
inline constexpr DragRate drag_rate{};
/// Acceleration of implicit drags, m/s^2, which follows from all other accelerations: the drags see the velocity that a
/// particle would have at the end of the step without them. The solver adds it to the acceleration when that is
/// complete. Only with integrators that set `allows_implicit`.
struct ImplicitAcceleration : Field<Rank::vector> {
    static constexpr std::string_view name = "implicit_acceleration", unit = "m/s^2";
};
inline constexpr ImplicitAcceleration implicit_acceleration{};

/// Mass of a particle, kg (kg/m in 2D).
struct Mass : Field<Rank::scalar> {
    static constexpr std::string_view name = "mass", unit = "kg";
    static constexpr bool given = true;
};
inline constexpr Mass mass{};

/// Density, kg/m^3.
struct Density : Field<Rank::scalar> {
    static constexpr std::string_view name = "density", unit = "kg/m^3";
    static constexpr std::string_view rate_name = "density_rate", rate_unit = "kg/m^3/s";
    static constexpr bool given = true;
};
inline constexpr Density density{};
inline constexpr Rate<Density> density_rate{};

/// Pressure, Pa.
struct Pressure : Field<Rank::scalar> {
    static constexpr std::string_view name = "pressure", unit = "Pa";
    static constexpr bool shown = true;
};
inline constexpr Pressure pressure{};

/// Deviatoric part of the Cauchy stress, Pa.
struct DeviatoricStress : Field<Rank::symmetric_tensor> {
    static constexpr std::string_view name = "deviatoric_stress", unit = "Pa";
    static constexpr std::string_view rate_name = "deviatoric_stress_rate", rate_unit = "Pa/s";
};
inline constexpr DeviatoricStress deviatoric_stress{};
inline constexpr Rate<DeviatoricStress> deviatoric_stress_rate{};

/// Velocity gradient, 1/s: component (i, j) is dv_i/dx_j.
struct VelocityGradientField : Field<Rank::tensor> {
    static constexpr std::string_view name = "velocity_gradient", unit = "1/s";
};
inline constexpr VelocityGradientField velocity_gradient{};

/// Velocity smoothed over the neighbours (XSPH), m/s.
struct SmoothedVelocity : Field<Rank::vector> {
    static constexpr std::string_view name = "smoothed_velocity", unit = "m/s";
};
inline constexpr SmoothedVelocity smoothed_velocity{};

/// Added to the velocity when particles are moved, and only then (XSPH, particle shifting), m/s.
struct TransportCorrection : Field<Rank::vector> {
    static constexpr std::string_view name = "transport_correction", unit = "m/s";
};
inline constexpr TransportCorrection transport_correction{};

/// Position when the solid was stress-free, m: the coordinates of a total-Lagrangian solid.
struct ReferencePosition : Field<Rank::vector> {
    static constexpr std::string_view name = "reference_position", unit = "m";
    static constexpr bool given = true;
};
inline constexpr ReferencePosition reference_position{};

/// Deformation gradient dx/dX of a total-Lagrangian solid.
struct DeformationGradientField : Field<Rank::tensor> {
    static constexpr std::string_view name = "deformation_gradient", unit = "1";
};
inline constexpr DeformationGradientField deformation_gradient{};

/// 1 for a particle that moves freely, 0 for one that is held where it is (clamped).
struct Mobility : Field<Rank::scalar> {
    static constexpr std::string_view name = "mobility", unit = "1";
    static constexpr bool given = true;
};
inline constexpr Mobility mobility{};

} // namespace imbibe
