// XSPH: the velocity smoothed over the neighbours, for gradients and, optionally, for moving the particles.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/term.hpp>

namespace imbibe {

/// Coefficients of Xsph.
struct XsphParameters {
    /// How far the velocity goes towards the mean of its neighbours: 0 not at all, 1 all the way. 0.5 in the paper.
    /// With XsphTransport keep it well below 1: at 1, velocities that alternate from particle to particle grow with any
    /// step.
    double strength = 0.5;

    /// Throws Error for a number out of range. @param where the phase or coupling in the message
    void check(std::string_view where) const {
        require(strength >= 0 && strength <= 1, where, ": XsphParameters::strength = ", strength,
                " (no unit); it must be from 0 to 1, usually 0.5");
    }
};

/// The mean of the neighbours' velocities relative to the particle's own, m/s: what Xsph sums.
struct RelativeMeanVelocity : Field<Rank::vector> {
    static constexpr std::string_view name = "relative_mean_velocity", unit = "m/s";
};
inline constexpr RelativeMeanVelocity relative_mean_velocity{};

/// Sets smoothed_velocity = v_a + 0.5 sum_b (m_b/rho_ab) (v_b - v_a) W_ab, in m/s, with the mean density rho_ab.
///
/// It is used by terms that name it, as VelocityGradient<Kernel, smoothed_velocity> and Continuity<Kernel,
/// smoothed_velocity>. The particles still move with their own velocity, unless XsphTransport stands beside this term.
/// One velocity for gradients, density and motion is the consistent choice; the paper, which leaves open what moves the
/// particles, uses it for the gradients and the density only.
///
/// Not for measuring velocities (it blurs over H) and not as a viscosity: it does not change the momentum.
///
/// Source: Monaghan (1989) and (1992); the paper, Eq. (19), there with the poly6 kernel.
template <class Kernel>
struct Xsph {
    using Parameters = XsphParameters;

    struct Sum {
        using reads = Fields<mass, density, velocity>;
        using adds = Fields<relative_mean_velocity>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            // v_a - v_b, which other terms of the sweep have, too
            return -(b[mass] / (0.5 * (a[density] + b[density])) * ab.value(Kernel{})) * (a[velocity] - b[velocity]);
        }
    };
    struct Smooth {
        using reads = Fields<velocity, relative_mean_velocity>;
        using sets = Fields<smoothed_velocity>;
        static constexpr bool in_packs = true;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            return a[velocity] + parameters.strength * a[relative_mean_velocity];
        }
    };
    using parts = Parts<Sum, Smooth>;
};

/// Sets transport_correction = smoothed_velocity - velocity, in m/s: the particles are then moved with the velocity of
/// this step plus this difference, that is, with the smoothed velocity; their momentum is untouched. Stands beside a
/// term that sets smoothed_velocity: `Xsph<Poly6>, XsphTransport`.
///
/// Keeps particles in order and from passing through each other, and makes density and position follow the same motion
/// when the density equation uses smoothed_velocity as well.
///
/// Not near walls and clamps that have no XSPH of their own: there the smoothed velocity is not that of the wall.
///
/// Source: Monaghan (1989).
struct XsphTransport {
    using reads = Fields<velocity, smoothed_velocity>;
    using sets = Fields<transport_correction>;
    static constexpr bool in_packs = true;

    IMBIBE_INLINE constexpr auto operator()(const auto& a) const { return a[smoothed_velocity] - a[velocity]; }
};

} // namespace imbibe
