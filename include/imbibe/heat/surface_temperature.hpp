// A wall at a prescribed temperature: the temperature it shows to the fluid, so that the fluid at its surface has the
// wall's temperature.
#pragma once

#include <imbibe/heat/enthalpy.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/wall/surface_distance.hpp>

#include <cmath>
#include <string_view>

namespace imbibe {

/// The temperature of a wall's surface, K: set by SurfaceTemperature or a user's term.
struct SurfaceTemperatureField : Field<Rank::scalar> {
    static constexpr std::string_view name = "surface_temperature", unit = "K";
    static constexpr bool shown = true;
};
inline constexpr SurfaceTemperatureField surface_temperature{};

/// sum_f W_af over the particles in contact with the wall, 1/m^3 (1/m^2 in 2D).
struct TemperatureWeight : Field<Rank::scalar> {
    static constexpr std::string_view name = "temperature_weight", unit = "1/m^3";
};
inline constexpr TemperatureWeight temperature_weight{};

/// sum_f (T_f - T_w) W_af over the same, K/m^3.
struct TemperatureSum : Field<Rank::scalar> {
    static constexpr std::string_view name = "temperature_sum", unit = "K/m^3";
};
inline constexpr TemperatureSum temperature_sum{};

/// sum_f k_f W_af over the same, W/(m^4 K).
struct ConductivitySum : Field<Rank::scalar> {
    static constexpr std::string_view name = "conductivity_sum", unit = "W/(m^4 K)";
};
inline constexpr ConductivitySum conductivity_sum{};

/// sum_f (x_f - x_a) W_af over the same, 1/m^2.
struct TemperatureOffset : Field<Rank::vector> {
    static constexpr std::string_view name = "temperature_offset", unit = "1/m^2";
};
inline constexpr TemperatureOffset temperature_offset{};

/// Coefficients of SurfaceTemperature.
struct SurfaceTemperatureParameters {
    double surface_temperature = 293.15; ///< T_w, K

    /// Throws Error for a number out of range. @param where the phase in the message
    void check(std::string_view where) const {
        require(std::isfinite(surface_temperature), where,
                ": SurfaceTemperatureParameters::surface_temperature = ", surface_temperature,
                " K; it must be a finite number (room temperature 293.15 K)");
    }
};

/// T_w, in K: a wall whose surface is kept at this temperature. Its enthalpy is the heat per mass of the wall that it
/// has taken up: `thermal_energy(scene[wall])` is the total, J.
///
/// If the temperature varies in space, or in time (`a.time`), use your own term that sets `surface_temperature` and
/// `stores` enthalpy in its place.
///
/// Not sufficient by itself: the coupling needs TemperatureExtrapolation `Into` the wall and HeatTransfer.
///
/// Source: a Dirichlet condition.
struct SurfaceTemperature {
    using Parameters = SurfaceTemperatureParameters;
    using stores = Fields<enthalpy>;
    struct Set {
        using reads = Fields<>;
        using sets = Fields<surface_temperature>;
        static constexpr bool in_packs = true;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            return typename std::remove_cvref_t<decltype(a)>::Scalar(parameters.surface_temperature);
        }
    };
    using parts = Parts<Set>;
    using reductions = Parts<ThermalEnergyOfParticle>;
};

/// T_a = T_w - (D/d - 1) sum_f (T_f - T_w) W_af / sum_f W_af, in K, for a particle a of a wall: the temperature of the
/// fluid or solid in front of it, extrapolated linearly through that of the surface, T_w, with the distances D and d of
/// SurfaceDistance; T_w itself without contact. Also its conductivity, the mean over the particles in contact.
///
/// Goes into the wall: `Coupling<Water, Plate, Into<Plate, TemperatureExtrapolation<>>, HeatTransfer<>>`, beside
/// SurfaceTemperature in the wall.
///
/// Not for a wall whose temperature changes by the heat it takes up: that is a phase with a HeatCapacity.
///
/// Source: as LinearNoSlipVelocity, for a temperature.
template <class Kernel = WendlandC2>
struct TemperatureExtrapolation {
    static constexpr bool one_sided = true;
    using Prepared = SurfaceDistance;
    struct Sum { // a: wall, b: particle in contact
        using reads = Fields<temperature, conductivity, surface_temperature>;
        using adds = Fields<temperature_weight, temperature_sum, conductivity_sum, temperature_offset>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const auto weight = ab.value(Kernel{});
            return values(weight, weight * (b[temperature] - a[surface_temperature]), weight * b[conductivity],
                          -weight * ab.offset);
        }
    };
    struct Continue {
        using reads =
            Fields<surface_temperature, temperature_weight, temperature_sum, conductivity_sum, temperature_offset>;
        using sets = Fields<temperature, conductivity>;
        Prepared prepared{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            const auto weight = max(a[temperature_weight], 1e-30);
            const auto D = sqrt(squared_norm(a[temperature_offset])) / weight;
            return values(a[surface_temperature] -
                              (positive_part(D / prepared.of(D) - 1) / weight) * a[temperature_sum],
                          a[conductivity_sum] / weight);
        }
    };
    using parts = Parts<Sum, Continue>;

    /// Computed from the scene's lattice.
    template <int dim>
    static Prepared prepare(const auto&, const auto&, const Lattice<dim>& lattice) {
        return SurfaceDistance::on<Kernel>(lattice);
    }
};

} // namespace imbibe
