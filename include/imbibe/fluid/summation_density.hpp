// Density from the present positions instead of the history of the motion: by summation, relative to a lattice.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/term.hpp>
#include <imbibe/kernels/wendland.hpp>

namespace imbibe {

/// sum_b V_0b W_ab, without unit, with the volumes V_0 = m/rho_0 at the reference density.
struct KernelSum : Field<Rank::scalar> {
    static constexpr std::string_view name = "kernel_sum", unit = "1";
};
inline constexpr KernelSum kernel_sum{};

/// The same sum on a full lattice of the phase's spacing, without unit: near 1, not 1.
struct LatticeKernelSum : Field<Rank::scalar> {
    static constexpr std::string_view name = "lattice_kernel_sum", unit = "1";
};
inline constexpr LatticeKernelSum lattice_kernel_sum{};

/// sum_b V_0b W_ab, without unit: how full the surroundings of a particle are. A part of SummationDensity and
/// SummationFloor, and a term of its own for couplings: `Into<Water, SummationNeighbours<>>` makes the particles of a
/// wall, a solid or another fluid count. Give those the spacing of the fluid, and layers over the whole support:
/// between two fluids, one with half the other's spacing, densities are 1.2 % off. Not beside a continuity equation
/// alone, which does not read it.
///
/// Source: Monaghan (1992), the summation of densities, over volumes instead of masses.
template <class Kernel = WendlandC2>
struct SummationNeighbours {
    using reads = Fields<mass>;
    using adds = Fields<kernel_sum>;

    IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
        return b[mass] * ab.value(Kernel{}) * (1 / b.material.density);
    }
};

/// sum over a square or cubic lattice of spacing^dim W, without unit; computed once, when the particles are added. The
/// reference for the kernel sum. The particle's own sum at the start would be too small if it was at a surface then.
/// Not for a phase that starts on another lattice, whose first sum differs.
///
/// Source: our own; the lattice is that of `fill`.
template <class Kernel = WendlandC2>
struct LatticeSum {
    static constexpr bool once = true;
    using sets = Fields<lattice_kernel_sum>;

    constexpr auto operator()(const auto& a) const {
        using A = std::remove_cvref_t<decltype(a)>;
        constexpr int dim = A::dimension;
        const double H = a.material.support_radius, spacing = max(a.material.spacing, 1e-30);
        const double share = a.material.spacing / max(H, 1e-30);
        const int reach = static_cast<int>(min(H / spacing, 30.0)), side = 2 * reach + 1;
        double total = 0;
        for (int k = 0; k < power<dim>(side); ++k) {
            double squared = 0;
            for (int d = 0, rest = k; d < dim; ++d, rest /= side)
                squared += sq((rest % side - reach) * share);
            total += Kernel::value(imbibe::sqrt(squared));
        }
        return typename A::Scalar(Kernel::template normalisation<dim>() * power<dim>(share) * total);
    }
};

namespace detail {

// rho_0 sum_b V_0b W_ab / (the same sum on a lattice), kg/m^3.
IMBIBE_INLINE constexpr auto summed_density(const auto& a) {
    return a.material.density * a[kernel_sum] / a[lattice_kernel_sum];
}

} // namespace detail

/// rho_a = rho_0 sum_b V_0b W_ab / (the same sum on a lattice), in kg/m^3.
///
/// Use it in place of Continuity, VolumeContinuity and other terms that add to the density rate (diffusion,
/// DensityFloor): it cannot drift, for any number of steps. For fluids without a free surface: periodic, or filled into
/// walls that count (`Into<Water, SummationNeighbours<>>` in the coupling).
///
/// Not with a free surface, except beside CohesivePressure: there half of the neighbours are missing, and the pressure
/// becomes a strong tension; beside Continuity take SummationFloor. Beside a term that adds to the density rate it does
/// not compile (SetTwice). Noisier than Continuity: the energy of a decaying vortex is right to 3 %, while single
/// particles are up to a fifth too fast.
/// A kernel with a narrow peak (Wendland, few neighbours) overrates the particle's own contribution.
///
/// Source: Monaghan (1992); in this normalisation Zhang, Rezavand and Hu (2020).
template <class Kernel = WendlandC2>
struct SummationDensity {
    struct Set {
        using reads = Fields<kernel_sum, lattice_kernel_sum>;
        using sets = Fields<density>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const { return detail::summed_density(a); }
    };
    using parts = Parts<SummationNeighbours<Kernel>, LatticeSum<Kernel>, Set>;
};

/// Coefficients of SummationFloor.
struct SummationFloorParameters {
    /// How fast the density follows, in units of c/spacing.
    double rate = 0.1;

    /// Throws Error for a number out of range. @param where the phase in the message
    void check(std::string_view where) const {
        require_not_negative(rate, where, "SummationFloorParameters::rate", "");
    }
};

/// drho_a/dt += rate c/spacing max(rho_sum - rho_a, 0), in kg/m^3/s, with rho_sum = rho_0 sum_b V_0b W_ab / (the same
/// sum on a lattice).
///
/// Use it beside Continuity or RiemannContinuity: particles that have come closer than their density says get the
/// density of their spacing, and are pushed apart again. At a free surface, where rho_sum is too small, the density of
/// the continuity equation is kept. The source sets rho = max(rho, rho_sum) at the start of a step; here it is a rate,
/// so it needs nothing from the integrator.
///
/// Not where the density must stay that of the continuity equation: on disordered particles rho_sum is noisy, and only
/// its upper half is taken, so the mean density and with it the pressure rises. Not without `Into<Water,
/// SummationNeighbours<>>` in the couplings with walls.
///
/// Source: Zhang, Rezavand and Hu (2020), the reinitialisation at free surfaces.
template <class Kernel = WendlandC2>
struct SummationFloor {
    static constexpr bool changes_volume = true;
    using Parameters = SummationFloorParameters;

    struct Raise {
        using reads = Fields<density, kernel_sum, lattice_kernel_sum>;
        using adds = Fields<density_rate>;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            const auto& fluid = a.material;
            const double per_time = parameters.rate * fluid.sound_speed / max(fluid.spacing, 1e-30);
            return per_time * positive_part(detail::summed_density(a) - a[density]);
        }
    };
    using parts = Parts<SummationNeighbours<Kernel>, LatticeSum<Kernel>, Raise>;

    static constexpr const char* limit_name = "summation floor";
    /// 2 spacing/(rate c), s: after a longer step the density would be further above the sum than it was below.
    static double time_step_limit(const auto& material, const TimeStepInput& in, const Parameters& parameters) {
        return 2 * in.spacing / max(parameters.rate * material.sound_speed, 1e-30);
    }
};

} // namespace imbibe
