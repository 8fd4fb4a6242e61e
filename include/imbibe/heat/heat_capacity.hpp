// A phase that stores heat without melting: its temperature is linear in its enthalpy.
#pragma once

#include <imbibe/heat/enthalpy.hpp>

#include <string_view>

namespace imbibe {

/// Coefficients of HeatCapacity.
struct HeatParameters {
    double heat_capacity = required;       ///< c, J/(kg K): water 4186, rubber 1900, steel 490
    double heat_conductivity = required;   ///< k, W/(m K): water 0.6, rubber 0.15, steel 50
    double reference_temperature = 293.15; ///< T_0, K: that of the particles when they are added

    /// The enthalpy, J/kg, at the temperature T, K: to start particles at another temperature than T_0,
    /// `scene[water][enthalpy](i) = heat.enthalpy_at(350)`.
    constexpr double enthalpy_at(double T) const { return heat_capacity * (T - reference_temperature); }
    /// k, W/(m K), for the time step limit.
    constexpr double greatest_conductivity() const { return heat_conductivity; }
    /// c, J/(kg K), for the same.
    constexpr double least_heat_capacity() const { return heat_capacity; }

    /// Throws Error for a number out of range. @param where the phase in the message
    void check(std::string_view where) const {
        detail::require_heat_number(heat_capacity, where, "HeatParameters::heat_capacity", "J/(kg K)", "water 4186");
        detail::require_heat_number(heat_conductivity, where, "HeatParameters::heat_conductivity", "W/(m K)",
                                    "water 0.6");
        require(std::isfinite(reference_temperature), where,
                ": HeatParameters::reference_temperature = ", reference_temperature,
                " K; it must be a finite number (room temperature 293.15 K)");
    }
};

/// T_a = T_0 + h_a/c, in K, the conductivity k and the potential k h_a/c of its flux: for a phase that stores heat.
/// HeatConduction moves the heat.
///
/// Not for a phase that melts or freezes: Melting.
///
/// Source: the definition of the heat capacity at constant pressure, dh = c dT.
struct HeatCapacity {
    using Parameters = HeatParameters;
    struct Set {
        using reads = Fields<enthalpy>;
        using sets = Fields<temperature, conductivity, conduction_potential>;
        static constexpr bool in_packs = true;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            using T = typename std::remove_cvref_t<decltype(a)>::Scalar;
            const auto above = (1 / parameters.heat_capacity) * a[enthalpy];
            return values(parameters.reference_temperature + above, T(parameters.heat_conductivity),
                          parameters.heat_conductivity * above);
        }
    };
    using parts = Parts<Set>;
    using reductions = Parts<ThermalEnergyOfParticle>;
};

} // namespace imbibe
