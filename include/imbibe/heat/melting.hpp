// A phase that melts and freezes: its temperature is constant while its enthalpy takes up the latent heat.
#pragma once

#include <imbibe/heat/enthalpy.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace imbibe {

/// The share of a particle that is liquid, without unit: 0 frozen, 1 molten.
struct LiquidFraction : Field<Rank::scalar> {
    static constexpr std::string_view name = "liquid_fraction", unit = "1";
    static constexpr bool shown = true;
};
inline constexpr LiquidFraction liquid_fraction{};

/// Coefficients of Melting. The density is the same, frozen and molten.
struct MeltingParameters {
    double solid_heat_capacity = required;  ///< c_s, J/(kg K): ice 2100
    double liquid_heat_capacity = required; ///< c_l, J/(kg K): water 4186
    double solid_conductivity = required;   ///< k_s, W/(m K): ice 2.2
    double liquid_conductivity = required;  ///< k_l, W/(m K): water 0.6
    double latent_heat = required;          ///< L, J/kg, all heat from the begin of melting to its end: water 3.34e5
    double melting_temperature = 273.15;    ///< T_m, K, at which it begins to melt
    double melting_range = 0;               ///< K, until all is molten; 0 for a pure substance such as water
    double reference_temperature = 293.15;  ///< T_0, K: that of the particles when they are added. At T_m or above they
                                            ///< are liquid, below it frozen

    /// The enthalpy at which it begins to melt, J/kg.
    constexpr double melting_enthalpy() const {
        const double above = reference_temperature - melting_temperature;
        return above < 0 ? -above * solid_heat_capacity : -latent_heat - (above - melting_range) * liquid_heat_capacity;
    }
    /// The enthalpy, J/kg, of particles of the temperature T, K, of which the share f is liquid where T is T_m.
    constexpr double enthalpy_at(double T, double f = 1) const {
        const double above = T - melting_temperature, h = melting_enthalpy();
        if (above < 0)
            return h + above * solid_heat_capacity;
        if (above > melting_range)
            return h + latent_heat + (above - melting_range) * liquid_heat_capacity;
        return h + latent_heat * (melting_range > 0 ? above / melting_range : f);
    }
    /// W/(m K), for the time step limit.
    constexpr double greatest_conductivity() const { return std::max(solid_conductivity, liquid_conductivity); }
    /// J/(kg K), for the same.
    constexpr double least_heat_capacity() const { return std::min(solid_heat_capacity, liquid_heat_capacity); }

    /// Throws Error for a number out of range. @param where the phase in the message
    void check(std::string_view where) const {
        using detail::require_heat_number;
        require_heat_number(solid_heat_capacity, where, "MeltingParameters::solid_heat_capacity", "J/(kg K)",
                            "ice 2100");
        require_heat_number(liquid_heat_capacity, where, "MeltingParameters::liquid_heat_capacity", "J/(kg K)",
                            "water 4186");
        require_heat_number(solid_conductivity, where, "MeltingParameters::solid_conductivity", "W/(m K)", "ice 2.2");
        require_heat_number(liquid_conductivity, where, "MeltingParameters::liquid_conductivity", "W/(m K)",
                            "water 0.6");
        require_heat_number(latent_heat, where, "MeltingParameters::latent_heat", "J/kg",
                            "water 3.34e5; what does not melt has a HeatCapacity instead");
        require_not_negative(melting_range, where, "MeltingParameters::melting_range", "K");
        require(std::isfinite(melting_temperature) && std::isfinite(reference_temperature), where,
                ": MeltingParameters::melting_temperature = ", melting_temperature,
                " K, reference_temperature = ", reference_temperature,
                " K; they must be finite numbers (water 273.15 K)");
        const double above = reference_temperature - melting_temperature;
        require(above < 0 || above >= melting_range, where,
                ": MeltingParameters::reference_temperature = ", reference_temperature,
                " K, where it is partly molten (", melting_temperature, " to ", melting_temperature + melting_range,
                " K); take one outside of that, and give particles another enthalpy, enthalpy_at(T)");
    }
};

/// T_a = T_m + (h_a - h_m)/c_s below the enthalpy h_m at which melting begins, T_m + T_r f_a during melting, with the
/// liquid fraction f_a = (h_a - h_m)/L from 0 to 1 and the range T_r, and T_m + T_r + (h_a - h_m - L)/c_l above, in K.
/// Also the conductivity, (1 - f) k_s + f k_l, and its integral from T_m on, the potential of the flux.
///
/// Use it in place of HeatCapacity. Frozen fluid still flows unless a term holds it: EnthalpyPorosity, or FrozenStress
/// with FrozenDrag.
///
/// Not for supercooling, and not where ice must expand against its surroundings: the density is constant.
///
/// Source: Voller and Cross (1981), the enthalpy method; by particles, Cleary (1998).
struct Melting {
    using Parameters = MeltingParameters;
    /// Numbers of the piecewise linear law.
    struct Prepared {
        double melting_enthalpy = 0; ///< h_m, J/kg
    };
    struct Set {
        using reads = Fields<enthalpy>;
        using sets = Fields<temperature, conductivity, conduction_potential, liquid_fraction>;
        static constexpr bool in_packs = true;
        Parameters parameters{};
        Prepared prepared{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            const Parameters& p = parameters;
            const auto h = a[enthalpy] - prepared.melting_enthalpy;
            const auto f = min(max((1 / p.latent_heat) * h, 0.0), 1.0);
            const auto below = (1 / p.solid_heat_capacity) * negative_part(h);
            const auto above = (1 / p.liquid_heat_capacity) * positive_part(h - p.latent_heat);
            const double more = p.liquid_conductivity - p.solid_conductivity;
            return values(p.melting_temperature + below + p.melting_range * f + above, p.solid_conductivity + more * f,
                          p.solid_conductivity * below + p.melting_range * f * (p.solid_conductivity + 0.5 * more * f) +
                              p.liquid_conductivity * above,
                          f);
        }
    };
    using parts = Parts<Set>;
    using reductions = Parts<ThermalEnergyOfParticle>;

    /// The enthalpy at which melting begins.
    template <int dim>
    static Prepared prepare(const auto&, const Lattice<dim>&, const Parameters& parameters) {
        return {.melting_enthalpy = parameters.melting_enthalpy()};
    }
};

} // namespace imbibe
