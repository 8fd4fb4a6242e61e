// Slow relaxation of the density to the summation density: a continuity equation that cannot drift.
#pragma once

#include <imbibe/fluid/summation_density.hpp>

namespace imbibe {

/// Coefficients of SummationRelaxation.
struct SummationRelaxationParameters {
    /// The time in which a deviation falls to 1/e, s. Must be given: about 0.3 of the time in which the flow crosses
    /// the vessel. It should be long compared with H/c, or it damps sound and adds the noise of the sum.
    double time = 0;

    /// Throws Error for a number out of range. @param where the phase in the message
    void check(std::string_view where) const {
        require(time > 0, where, ": SummationRelaxationParameters::time = ", time,
                " s; it must be given and above 0 s, about 0.3 of the time in which the flow crosses the vessel");
    }
};

/// drho_a/dt += (rho_sum - rho_a)/time, in kg/m^3/s, with rho_sum = rho_0 sum_b V_0b W_ab / (the same sum on a
/// lattice).
///
/// Use it beside Continuity, VolumeContinuity or CorrectedContinuity, which follow the flow from moment to moment but
/// ignore the shifts of particles: with shifting, above all off walls, density and positions drift apart, and the fluid
/// fills a closed box unevenly. A lid-driven cavity, 24 particles across at Re = 100, keeps 0.48 to 0.68 of its flow,
/// with a density 14 to 20 % too high; with this beside ShiftingNeighbours the flow is 6 to 13 % too slow, and the
/// density right to 2 % (tests/validation/more/test_reference_cavity.cpp, 24 starts). docs/validation.md, fsi1 to fsi3:
/// a channel with a cylinder.
///
/// For fluids without a free surface: periodic, or between walls and solids that count (`Into<Water,
/// SummationNeighbours<>>` in every coupling), of the fluid's spacing and as many layers as the support reaches.
///
/// Not with a free surface, where half of the neighbours are missing and the pressure becomes a strong tension. Not
/// with a time as short as the period of the flow's oscillations. Beside SummationDensity it does not compile
/// (SetTwice).
///
/// Source: own. The effect of re-initialising the density every few steps (Colagrossi and Landrini 2003), spread over
/// all steps: no step has a jump, and the integrator need not know.
template <class Kernel = WendlandC2>
struct SummationRelaxation {
    static constexpr bool changes_volume = true;
    using Parameters = SummationRelaxationParameters;

    struct Pull {
        using reads = Fields<density, kernel_sum, lattice_kernel_sum>;
        using adds = Fields<density_rate>;
        static constexpr bool in_packs = true;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            return (1 / max(parameters.time, 1e-30)) * (detail::summed_density(a) - a[density]);
        }
    };
    using parts = Parts<SummationNeighbours<Kernel>, LatticeSum<Kernel>, Pull>;

    static constexpr const char* limit_name = "summation relaxation";
    /// 2 time, s: after a longer step the density would be further from the sum than before.
    static double time_step_limit(const auto&, const TimeStepInput&, const Parameters& parameters) {
        return 2 * parameters.time;
    }
};

} // namespace imbibe
