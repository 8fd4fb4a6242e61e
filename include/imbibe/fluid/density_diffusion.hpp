// Density diffusion (delta-SPH): removes the checkerboard from the pressure of a weakly compressible fluid.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/fluid/pairwise_laplacian.hpp>
#include <imbibe/fluid/volume.hpp>
#include <imbibe/kernels/wendland.hpp>

namespace imbibe {

/// Coefficients of DensityDiffusion.
struct DensityDiffusionParameters {
    /// Strength, without unit. 0.1 is the usual value; more smears the pressure and, above about 0.5, costs time step.
    double delta = 0.1;

    /// Throws Error for a number out of range. @param where the phase or coupling in the message
    void check(std::string_view where) const {
        require_not_negative(delta, where, "DensityDiffusionParameters::delta", "");
    }
};

/// drho_a/dt += 2 delta h c sum_b V_b (rho_b - rho_a - s_ab rho_0/c^2 g.(x_b - x_a)) (x_b - x_a).grad_a W_ab / |x_ab|^2
///
/// in kg/m^3/s, with h = H/2, the reference density rho_0 and the sound speed c of the material, gravity g, and the
/// mean s_ab of the two particles' supported_share. (x_b - x_a).grad_a W_ab is positive, so a particle lighter than its
/// neighbours becomes heavier: it smooths.
/// The subtracted part is the density difference of the fluid at rest, linear in g.x: exact for LinearState, and for
/// Tait up to the square of g depth/c^2. Without it a column of water slowly swells at its surface. It is weighted with
/// the supported share (SupportedShare): in free fall there is no hydrostatic pressure.
///
/// For one fluid, beside Continuity or VolumeContinuity. What one particle gains the other loses (V_a drho_a
/// is antisymmetric), so the mean density weighted with volume does not drift.
///
/// Not in a coupling: across an interface, and towards a wall, densities differ for good reason. Not a substitute for
/// viscosity: it damps sound, not motion. Not in creeping flow: with it the narrow pore of
/// cases/validation/one_pore.hpp has a tenth less resistance (docs/validation.md). In a tank that is accelerated
/// sideways, take AntuonoDiffusion, or pass the acceleration as part of gravity (Solver::set_gravity).
///
/// Source: Molteni and Colagrossi (2009); hydrostatic part: Fourtakas et al. (2019), here linearised; s_ab is own.
template <class Kernel = WendlandC2>
struct DensityDiffusion {
    using effect = effects::density_diffusion;
    static constexpr bool within_phases = true;
    using Parameters = DensityDiffusionParameters;

    struct Smooth {
        using reads = Fields<density, volume, supported_share>;
        using adds = Fields<density_rate>;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const double c = a.material.sound_speed;
            const auto share = 0.5 * a.material.density / sq(c) * (a[supported_share] + b[supported_share]);
            const auto excess = a[density] - b[density] - share * dot(ab.gravity(), ab.offset);
            // grad W = F x_ab with F < 0: F is all that is left of (x_ab . grad W)/|x_ab|^2.
            return (parameters.delta * c) * ab.support_radius * b[volume] * excess * ab.gradient(Kernel{});
        }
    };
    using parts = Parts<Volume, Smooth>;

    static constexpr const char* limit_name = "density diffusion";
    /// 2 H/(1.3 S delta c), s, with S = 14 for WendlandC2: 2 over the fastest rate of decay, 1.1 H/c for delta = 0.1.
    static double time_step_limit(const auto& material, const TimeStepInput& in, const Parameters& parameters) {
        return detail::pairwise_diffusion_limit<Kernel>(
            parameters.delta * 0.5 * in.support_radius * material.sound_speed, in);
    }
};

} // namespace imbibe
