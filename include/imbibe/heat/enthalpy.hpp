// The basis of heat: the fields that its terms share, and the heat of a phase as an energy.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/phase.hpp>
#include <imbibe/core/term.hpp>

#include <cmath>
#include <string_view>
#include <type_traits>

namespace imbibe {

/// Heat per mass above that at the reference temperature of the phase, J/kg: 0 for added particles. It is integrated,
/// and the temperature follows from it, so heat is conserved through melting as well. For a wall with a
/// SurfaceTemperature it is the heat that the wall has taken up since the start.
struct Enthalpy : Field<Rank::scalar> {
    static constexpr std::string_view name = "enthalpy", unit = "J/kg";
    static constexpr std::string_view rate_name = "enthalpy_rate", rate_unit = "W/kg";
};
inline constexpr Enthalpy enthalpy{};
inline constexpr Rate<Enthalpy> enthalpy_rate{};

/// Temperature, K. Terms use only differences of it, so degrees Celsius work as well.
struct Temperature : Field<Rank::scalar> {
    static constexpr std::string_view name = "temperature", unit = "K";
    static constexpr bool shown = true;
};
inline constexpr Temperature temperature{};

/// The integral of the conductivity over the temperature, W/m: if the conductivity depends on the temperature alone,
/// the heat flux is minus its gradient (Kirchhoff 1894).
struct ConductionPotential : Field<Rank::scalar> {
    static constexpr std::string_view name = "conduction_potential", unit = "W/m";
};
inline constexpr ConductionPotential conduction_potential{};

/// Thermal conductivity, W/(m K).
struct Conductivity : Field<Rank::scalar> {
    static constexpr std::string_view name = "conductivity", unit = "W/(m K)";
};
inline constexpr Conductivity conductivity{};

/// Heat above that at the reference temperature, J, summed by `thermal_energy`.
struct ThermalEnergy {
    static constexpr std::string_view name = "thermal energy", unit = "J";
};

/// m h of a particle, J: a reduction of the terms that keep heat.
///
/// Not a term to be listed by itself.
///
/// Source: the definition of the enthalpy.
struct ThermalEnergyOfParticle {
    using reads = Fields<mass, enthalpy>;
    using reduces = Sum<ThermalEnergy>;

    double operator()(const auto& a) const { return a[mass] * a[enthalpy]; }
};

namespace detail {

// Are these the parameters of a term that gives a phase heat capacity and conductivity?
template <class P>
concept HeatLaw = requires(const P& law) {
    law.greatest_conductivity();
    law.least_heat_capacity();
};

// Is this a phase with such a term?
template <class Material>
inline constexpr bool holds_heat = false;
template <class Material>
requires requires(const Material& material) {
    material.coefficients;
}
inline constexpr bool holds_heat<Material> = []<class... P>(TypeList<P...>) {
    return (HeatLaw<P> || ...);
}(typename decltype(Material::coefficients)::List{});

// Calls f(law) with the heat parameters of a phase, if a term of it has such.
constexpr void with_heat_law(const auto& material, const auto& f) {
    [[maybe_unused]] const auto one = [&]<class P>(std::type_identity<P>) {
        if constexpr (HeatLaw<P>)
            f(material.coefficients.template get<P>());
    };
    [&]<class... P>(TypeList<P...>) {
        (one(std::type_identity<P>{}), ...);
    }(typename std::remove_cvref_t<decltype(material.coefficients)>::List{});
}

// The greatest conductivity of a phase, W/(m K); that of the other one if it has none.
constexpr double greatest_conductivity(const auto& material, double of_the_other) {
    double k = of_the_other;
    with_heat_law(material, [&](const auto& law) { k = law.greatest_conductivity(); });
    return k;
}

inline void require_heat_number(double value, std::string_view where, std::string_view name, std::string_view unit,
                                std::string_view remedy) {
    require(std::isfinite(value) && value > 0, where, ": ", name, " = ", value, " ", unit,
            value == required ? " (not given)" : "", "; it must be a finite number above 0 ", unit, " (", remedy, ")");
}

} // namespace detail

} // namespace imbibe
