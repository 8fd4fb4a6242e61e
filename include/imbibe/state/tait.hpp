// Tait's equation of state: a stiff liquid that stands in for an incompressible one.
#pragma once

#include <imbibe/state/compression_energy.hpp>
#include <imbibe/state/wave_speed.hpp>

#include <cmath>

namespace imbibe {

// Advice, printed as a template argument.
struct give_it_a_whole_number_from_1_on_such_as_7_of_water;

namespace rules {
/// Rule: the exponent of an equation of state is a whole number from 1 on.
template <class Equation, class Advice>
struct ExponentBelowOne {
    static_assert(sizeof(Equation) == 0, "imbibe: the exponent of this equation of state is below 1");
};
} // namespace rules

/// p = rho_0 c^2 / gamma ((rho/rho_0)^gamma - 1), in Pa.
///
/// A liquid with artificial compressibility: with a sound speed c of ten times the greatest speed its density stays
/// within about 1 % of rho_0. gamma = 7 is water's; the paper leaves it open. The power is written as (rho -
/// rho_0)/rho_0 times a geometric sum, so that the pressure keeps its digits in float near rho_0.
///
/// Not for gases, not for real sound (c is not the liquid's), and not where density comes from summation near a free
/// surface: its deficit there would be read as tension. Below rho_0 the pressure is negative, and a fluid in tension
/// forms clumps.
///
/// Source: Cole (1948); Monaghan (1994); the paper, Eq. (8).
template <int gamma = 7>
struct Tait {
    using reads = Fields<density>;
    using sets = Fields<pressure>;
    static constexpr bool in_packs = true;

    IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
        using T = typename std::remove_cvref_t<decltype(a)>::Scalar;
        const auto& material = a.material;
        const T ratio = a[density] / material.density;
        T terms = T(1); // 1 + r + ... + r^(gamma - 1)
        for (int k = 1; k < exponent; ++k)
            terms = T(1) + ratio * terms;
        return (sq(material.sound_speed) / exponent) * (a[density] - material.density) * terms;
    }

    /// The density at a pressure p, Pa, above -rho_0 c^2/gamma: rho = rho_0 (1 + gamma p/(rho_0 c^2))^(1/gamma),
    /// kg/m^3.
    static double density_at(const auto& material, double p) {
        const double stiffness = material.density * sq(material.sound_speed) / exponent;
        return material.density * std::pow(1 + p / stiffness, 1.0 / exponent);
    }

    using reductions = Parts<CompressionEnergy>;

    static constexpr const char* limit_name = "sound";
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        // Not in the class: clang++ 14 would then report that the term has no such class, a second error.
        if constexpr (gamma < 1)
            detail::break_rule<rules::ExponentBelowOne<Tait, give_it_a_whole_number_from_1_on_such_as_7_of_water>>();
        return acoustic_time_step(material, in);
    }

private:
    // For a refused exponent, 1 lets everything else compile, so that there is one error.
    static constexpr int exponent = gamma >= 1 ? gamma : 1;
};

} // namespace imbibe
