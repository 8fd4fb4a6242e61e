// Particle shifting by the rate of strain: keeps particles in order where the flow shears them, and only there.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/term.hpp>
#include <imbibe/fluid/corrected_gradients.hpp>
#include <imbibe/fluid/particle_shifting.hpp>

#include <cmath>
#include <limits>

namespace imbibe {

/// Coefficients of StrainShifting.
struct StrainShiftingParameters {
    /// Strength: shifting velocity over the rate of shear times H^2 times the gradient of concentration.
    double strength = 0.5;
    /// The farthest a particle is shifted in one step; see ParticleShiftingParameters::most_in_a_step.
    double most_in_a_step = 0.035;

    /// Throws Error for a number out of range. @param where the phase in the message
    void check(std::string_view where) const {
        require_not_negative(strength, where, "StrainShiftingParameters::strength", "");
        require(std::isfinite(most_in_a_step) && most_in_a_step > 0, where,
                ": StrainShiftingParameters::most_in_a_step = ", most_in_a_step,
                "; it must be finite and above 0, usually 0.035");
    }
};

/// The gradient of concentration, sum_b V_b grad_a W_ab, 1/m. A part of StrainShifting, and a term of its own for
/// couplings: `Into<Water, ConcentrationNeighbours<>>` makes the particles of a wall or a solid, which needs its own
/// Volume, count as neighbours.
///
/// Not in a phase: its StrainShifting has it already.
///
/// Source: Lind, Xu, Stansby and Rogers (2012).
template <class Kernel = WendlandC2>
struct ConcentrationNeighbours {
    struct Sum {
        using reads = Fields<volume>;
        using adds = Fields<concentration_gradient>;

        IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
            return along(ab, b[volume] * ab.gradient(Kernel{}));
        }
    };
    using parts = Parts<Volume, Sum>;
};

/// transport_correction = - (1 - s_a) min(strength gamma_a H^2, 0.035 H^3/(spacing dt)) g_a, in m/s, with the rate of
/// shear gamma = sqrt(2 E:E) of the raw rate of strain E of CorrectedContinuity, the gradient of concentration g =
/// sum_b V_b grad_a W_ab, and the surface indicator s of InnerCorrection; both terms must stand beside it. Particles
/// are moved with v + transport_correction; their momentum is untouched.
///
/// A sheared lattice becomes disordered; this restores its order at the rate at which shear moves the particles. It is
/// the same in every frame, and shifts nothing without shear. Mass and momentum are conserved exactly.
///
/// With CorrectedPressure, which does not keep particles in order by itself (the method CorrectedGradients lists all of
/// them). For the last bound see ParticleShifting.
///
/// Not beside another term that moves particles (ParticleShifting, XsphTransport). Not with kernels under which
/// particles pair: the factor of ParticleShifting against that is left out (Wendland's need none).
///
/// Source: Lind, Xu, Stansby and Rogers (2012) for the gradient of concentration; the rate of shear as its factor is
/// own.
template <class Kernel = WendlandC2>
struct StrainShifting {
    using Parameters = StrainShiftingParameters;

    struct Shift {
        using reads = Fields<raw_strain_rate, concentration_gradient, surface_indicator>;
        using sets = Fields<transport_correction>;
        static constexpr bool in_packs = true;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            using T = typename std::remove_cvref_t<decltype(a)>::Scalar;
            const double H = a.material.support_radius;
            const auto& E = a[raw_strain_rate];
            T diffusivity = parameters.strength * H * H * sqrt(2 * dot(E, E));
            if (a.time_step > 0)
                diffusivity =
                    min(diffusivity, T(parameters.most_in_a_step * H * H * H / (a.material.spacing * a.time_step)));
            return -((1 - a[surface_indicator]) * diffusivity) * a[concentration_gradient];
        }
    };
    using parts = Parts<Volume, typename ConcentrationNeighbours<Kernel>::Sum, Shift>;
};

} // namespace imbibe
