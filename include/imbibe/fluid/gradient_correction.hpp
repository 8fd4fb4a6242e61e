// Corrected gradients in a fluid, and the density diffusion that uses them.
#pragma once

#include <imbibe/core/lattice.hpp>
#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/surface_indicator.hpp>
#include <imbibe/fluid/volume.hpp>
#include <imbibe/kernels/moment_matrix.hpp>

#include <cmath>

namespace imbibe {

/// Coefficients of CurrentCorrection.
struct CurrentCorrectionParameters {
    /// The correction is full where 1/|M_a^-1|, nearly the least moment in any direction, is at least this. With 3
    /// spacings of WendlandC2 it is 0.71 (0.58 in 3D) inside, 0.23 at a corner (0.13 at that of a cube) and 0 for a
    /// thread, a sheet in 3D or a drop of one particle.
    double full_above = 0.08;
    /// No correction where it is below this; a straight ramp between the two.
    double none_below = 0.04;

    /// Throws Error for a number out of range. @param where the phase in the message
    void check(std::string_view where) const {
        require_not_negative(none_below, where, "CurrentCorrectionParameters::none_below", "");
        require(full_above >= none_below, where, ": CurrentCorrectionParameters::full_above = ", full_above,
                "; it must be at least none_below, ", none_below);
    }
};

/// The sum over neighbours of CurrentCorrection: M_a = sum_b V_b (x_b - x_a) (x) grad_a W_ab, without unit. A part of
/// CurrentCorrection, and a term of its own for couplings: `Into<Water, CorrectionNeighbours<>>` makes the particles of
/// a wall or a solid, which needs its own Volume, count as neighbours. Without it gradients are corrected as if the
/// wall were a free surface.
/// Not in a phase: its CurrentCorrection has it already.
///
/// Source: Bonet and Lok (1999), whose correction is the inverse of it; see CurrentCorrection.
template <class Kernel = WendlandC2>
struct CorrectionNeighbours {
    using corrected_kernel = Kernel;
    struct Sum {
        using reads = Fields<volume>;
        using adds = Fields<moment_matrix>;

        IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
            const auto weight = -(b[volume] * ab.gradient(Kernel{}));
            return weight * symmetric_part(outer(ab.offset, ab.offset));
        }
    };
    using parts = Parts<Volume, Sum>;
};

/// L_a = M_a^-1, without unit, from M_a = sum_b V_b (x_b - x_a) (x) grad_a W_ab with the present positions. L_a times
/// the gradient sum_b V_b (f_b - f_a) grad_a W_ab is then exact for a linear field f, also at a free surface and beside
/// a wall that does not count.
///
/// Evaluated in every step, beside terms that correct a gradient: in a fluid AntuonoDiffusion, CorrectedContinuity,
/// CorrectedPressure, CorrectedViscosity; in a solid with a stress rate CorrectedContinuity, CorrectedVelocityGradient,
/// CorrectedStressForce. For a particle without neighbours in all directions (single drops, threads) M cannot be
/// inverted, and L goes over to the identity. In a coupling, use CorrectionNeighbours.
///
/// Not for a total-Lagrangian solid: that takes ReferenceCorrection, which is computed once.
///
/// Source: Randles and Libersky (1996); Bonet and Lok (1999).
template <class Kernel = WendlandC2>
struct CurrentCorrection {
    using corrected_kernel = Kernel;
    using Parameters = CurrentCorrectionParameters;

    struct Invert {
        using reads = Fields<moment_matrix>;
        using sets = Fields<gradient_correction>;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            return detail::inverse_or_identity(a[moment_matrix], parameters.full_above, parameters.none_below);
        }
    };
    using parts = Parts<Volume, typename CorrectionNeighbours<Kernel>::Sum, Invert>;
};

/// Coefficients of InnerCorrection.
struct InnerCorrectionParameters {
    /// The correction is full where 1/|M_a^-1|, nearly the least moment in any direction, is at least this share of
    /// what it is on the lattice.
    double full_above = 0.97;
    /// No correction where it is below this share; a straight ramp between the two.
    double none_below = 0.88;

    /// Throws Error for a number out of range. @param where the phase in the message
    void check(std::string_view where) const {
        require_not_negative(none_below, where, "InnerCorrectionParameters::none_below", "");
        require(full_above > none_below, where, ": InnerCorrectionParameters::full_above = ", full_above,
                "; it must be above none_below, ", none_below);
    }
};

/// What InnerCorrection prepares from the lattice.
struct PreparedInnerCorrection {
    double full_above = 0.69, none_below = 0.62; ///< for 1/|M^-1| itself
};

/// L_a = 1 + t_a (M_a^-1 - 1), without unit, with M of CurrentCorrection and t_a = 1 inside the fluid and 0 at its free
/// surface; sets the surface indicator, 1 - t_a, too.
///
/// Where particles are sheared out of their lattice, M is not the identity, and a uniform pressure p resists the shear
/// like a solid of shear modulus up to 0.07 p. The correction removes this. At a free surface, where the pressure is
/// small and the inverse large, terms stay uncorrected: films and drops keep off walls, and no time step limit depends
/// on L.
///
/// Use it instead of CurrentCorrection, beside CorrectedContinuity and CorrectedPressure, with StrainShifting or
/// ParticleShifting. In a coupling, use CorrectionNeighbours `Into` the fluid: a wall is no free surface.
///
/// Not where gradients must be exact at the free surface.
///
/// Source: the inverse, Randles and Libersky (1996), Bonet and Lok (1999); the stress -p M of the pair force and its
/// gate are own.
template <class Kernel = WendlandC2>
struct InnerCorrection {
    using corrected_kernel = Kernel;
    using Parameters = InnerCorrectionParameters;
    using Prepared = PreparedInnerCorrection;

    struct Invert {
        using reads = Fields<moment_matrix>;
        using sets = Fields<gradient_correction, surface_indicator>;
        static constexpr bool in_packs = true;
        Prepared prepared{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            const auto inverse = detail::gated_inverse(a[moment_matrix], prepared.full_above, prepared.none_below);
            return values(inverse.matrix, 1 - inverse.trust);
        }
    };
    using parts = Parts<Volume, typename CorrectionNeighbours<Kernel>::Sum, Invert>;

    /// The shares of 1/|M^-1| = M_xx/sqrt(dim) of the lattice.
    template <int dim>
    static Prepared prepare(const auto&, const Lattice<dim>& lattice, const Parameters& parameters) {
        const double moment = lattice.volume() / dim * lattice.sum([](const auto& ab) {
            return -sq(ab.distance) * ab.gradient(Kernel{});
        });
        const double whole = moment / std::sqrt(dim);
        return {.full_above = parameters.full_above * whole, .none_below = parameters.none_below * whole};
    }
};

/// sum_b V_b (rho_b - rho_a) grad_a W_ab, kg/m^4: the gradient of the density before its correction.
struct RawDensityGradient : Field<Rank::vector> {
    static constexpr std::string_view name = "raw_density_gradient", unit = "kg/m^4";
};
inline constexpr RawDensityGradient raw_density_gradient{};

/// Gradient of the density, kg/m^4.
struct DensityGradient : Field<Rank::vector> {
    static constexpr std::string_view name = "density_gradient", unit = "kg/m^4";
};
inline constexpr DensityGradient density_gradient{};

/// Coefficients of AntuonoDiffusion.
struct AntuonoDiffusionParameters {
    /// Strength, without unit; 0.1 is the usual value.
    double delta = 0.1;

    /// Throws Error for a number out of range. @param where the phase in the message
    void check(std::string_view where) const {
        require_not_negative(delta, where, "AntuonoDiffusionParameters::delta", "");
    }
};

/// drho_a/dt += 2 delta h c sum_b V_b (rho_b - rho_a - (G_a + G_b)/2.(x_b - x_a)) (x_b - x_a).grad_a W_ab / |x_ab|^2
///
/// in kg/m^3/s, with h = H/2, the sound speed c, and the corrected gradient G_a = L_a sum_b V_b (rho_b - rho_a) grad_a
/// W_ab with L of CurrentCorrection, which must stand beside it: `CurrentCorrection<K>, AntuonoDiffusion<K>`.
///
/// A density that is linear in space is left alone, also at the free surface: no pressure gradient, hydrostatic or not,
/// is smoothed away, in a tank at rest or accelerated. Conserves the volume-weighted mean density, as DensityDiffusion
/// does. Use it instead of DensityDiffusion where gravity is not the only acceleration. It costs one more sweep.
///
/// Not in a coupling: across an interface densities differ for good reason. Not for a fluid of two densities. Not where
/// walls or solids count in L (CorrectionNeighbours in a coupling): its gradient is summed over the fluid alone, and
/// would be half its true value beside a wall.
///
/// Source: Antuono, Colagrossi, Marrone and Molteni (2010).
template <class Kernel = WendlandC2>
struct AntuonoDiffusion {
    using effect = effects::density_diffusion;
    using corrected_kernel = Kernel;
    static constexpr bool within_phases = true;
    /// Its gradient ignores walls that count in the correction.
    using never_in_couplings = CorrectionNeighbours<Kernel>;
    using Parameters = AntuonoDiffusionParameters;

    struct Sum {
        using reads = Fields<density, volume>;
        using adds = Fields<raw_density_gradient>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            return along(ab, b[volume] * (b[density] - a[density]) * ab.gradient(Kernel{}));
        }
    };
    struct Correct {
        using reads = Fields<raw_density_gradient, gradient_correction>;
        using sets = Fields<density_gradient>;
        static constexpr bool in_packs = true;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            return a[gradient_correction] * a[raw_density_gradient];
        }
    };
    struct Smooth {
        using reads = Fields<density, volume, density_gradient>;
        using adds = Fields<density_rate>;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const auto linear = 0.5 * dot(a[density_gradient] + b[density_gradient], ab.offset);
            const auto excess = a[density] - b[density] - linear;
            return (parameters.delta * a.material.sound_speed) * ab.support_radius * b[volume] * excess *
                   ab.gradient(Kernel{});
        }
    };
    using parts = Parts<Volume, Sum, Correct, Smooth>;

    static constexpr const char* limit_name = DensityDiffusion<Kernel>::limit_name;
    /// The limit of DensityDiffusion, s: the fastest-decaying mode, from particle to particle, has no linear part to
    /// subtract.
    static double time_step_limit(const auto& material, const TimeStepInput& in, const Parameters& parameters) {
        return DensityDiffusion<Kernel>::time_step_limit(material, in, {.delta = parameters.delta});
    }
};

} // namespace imbibe
