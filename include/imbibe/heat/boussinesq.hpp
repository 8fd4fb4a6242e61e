// Natural convection: the buoyancy of a fluid that expands with its temperature.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/heat/enthalpy.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

#include <cmath>
#include <string_view>

namespace imbibe {

/// Coefficients of Boussinesq.
struct BoussinesqParameters {
    double thermal_expansion = 0;        ///< beta, 1/K: water at 20 degrees Celsius 2.1e-4, air 3.4e-3
    double neutral_temperature = 293.15; ///< T_n, K: the temperature without buoyancy

    /// Throws Error for a number out of range. @param where the phase in the message
    void check(std::string_view where) const {
        require(std::isfinite(thermal_expansion), where,
                ": BoussinesqParameters::thermal_expansion = ", thermal_expansion,
                " 1/K; it must be a finite number (water 2.1e-4 1/K)");
        require(std::isfinite(neutral_temperature), where,
                ": BoussinesqParameters::neutral_temperature = ", neutral_temperature,
                " K; it must be a finite number (room temperature 293.15 K)");
    }
};

/// dv_a/dt = - beta (T_a - T_n) g, in m/s^2: the buoyancy of warm fluid. The density of its particles remains that of
/// their pressure.
///
/// Not where beta times the temperature differences exceeds about 0.1: the change of volume then matters.
///
/// Source: Boussinesq (1903); Oberbeck (1879).
struct Boussinesq {
    using Parameters = BoussinesqParameters;
    struct Rise {
        using reads = Fields<temperature>;
        using adds = Fields<acceleration>;
        static constexpr bool in_packs = true;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            return (parameters.thermal_expansion * (parameters.neutral_temperature - a[temperature])) * a.gravity();
        }
    };
    using parts = Parts<Rise>;
};

/// beta (T_n - T_f) rho_f g.(x_a - x_f) W_af, Pa/m^3, added to the sum of PressureExtrapolation: the buoyancy of a
/// fluid with Boussinesq. `Into` the wall or solid, beside PressureExtrapolation.
///
/// Without it the pressure of the wall rises downwards as if the fluid did not expand, and the wall exerts a spurious
/// force on the fluid.
///
/// Not for a fluid without Boussinesq, whose coefficients it needs.
///
/// Source: as PressureExtrapolation, with the fluid's whole weight.
template <class Kernel = WendlandC2>
struct BoussinesqExtrapolation {
    static constexpr bool one_sided = true;
    using reads = Fields<density, temperature>;
    using adds = Fields<extrapolation_sum>;

    IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
        const BoussinesqParameters& of = b.material.coefficients.template get<BoussinesqParameters>();
        return (of.thermal_expansion * b[density] * (of.neutral_temperature - b[temperature])) *
               (dot(ab.gravity(), ab.offset) * ab.value(Kernel{}));
    }
};

} // namespace imbibe
