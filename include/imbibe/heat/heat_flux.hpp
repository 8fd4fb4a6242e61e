// A wall that heats or cools adjacent particles with a given power per area.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/lattice.hpp>
#include <imbibe/fluid/volume.hpp>
#include <imbibe/heat/enthalpy.hpp>
#include <imbibe/kernels/wendland.hpp>

#include <cmath>
#include <string_view>

namespace imbibe {

/// The power per area that a wall gives, W/m^2: set by HeatFlux or a user's term.
struct HeatFluxField : Field<Rank::scalar> {
    static constexpr std::string_view name = "heat_flux", unit = "W/m^2";
    static constexpr bool shown = true;
};
inline constexpr HeatFluxField heat_flux{};

/// sum_b V_b grad_a W_ab over the particles b of heating walls, 1/m.
struct HeatedSurface : Field<Rank::vector> {
    static constexpr std::string_view name = "heated_surface", unit = "1/m";
};
inline constexpr HeatedSurface heated_surface{};

/// sum_b q_b V_b grad_a W_ab over the same, W/m^3.
struct SurfaceHeating : Field<Rank::vector> {
    static constexpr std::string_view name = "surface_heating", unit = "W/m^3";
};
inline constexpr SurfaceHeating surface_heating{};

/// Coefficients of HeatFlux.
struct HeatFluxParameters {
    double heat_flux = 0; ///< q, W/m^2: above 0 the wall heats, below it cools

    /// Throws Error for a number out of range. @param where the phase in the message
    void check(std::string_view where) const {
        require(std::isfinite(heat_flux), where, ": HeatFluxParameters::heat_flux = ", heat_flux,
                " W/m^2; it must be a finite number (a hot plate 1e4 W/m^2)");
    }
};

/// q, in W/m^2: a wall that heats with this power per area of its surface.
///
/// If the flux varies in space, or in time (`a.time`), use your own term that sets `heat_flux` in its place.
///
/// Not sufficient by itself: the coupling needs HeatFromWalls `Into` the heated phase.
///
/// Source: a Neumann condition.
struct HeatFlux {
    using Parameters = HeatFluxParameters;
    struct Set {
        using reads = Fields<>;
        using sets = Fields<heat_flux>;
        static constexpr bool in_packs = true;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            return typename std::remove_cvref_t<decltype(a)>::Scalar(parameters.heat_flux);
        }
    };
    using parts = Parts<Volume, Set>;
};

/// The numbers that HeatFromWalls prepares from the lattice.
struct PreparedHeatFlux {
    double factor = 2; ///< 1 over the sum of |g_a| over the layers in front of a plane face, times the spacing
};

/// dh_a/dt = 1/rho_a factor (s_a . g_a)/|g_a|, in W/kg, with g_a = sum_b V_b grad_a W_ab over the particles b of walls
/// that have a HeatFlux q, and s_a = sum_b q_b V_b grad_a W_ab. In the coupling with them, `Into` the fluid or solid
/// that they heat: `Coupling<Water, Plate, Into<Water, HeatFromWalls<>>>`.
///
/// The magnitude |g| is the derivative of the share of the kernel in the wall, and sums up to 1/2 across a plane face;
/// the factor makes that exact on the scene's lattice. So the heat is the flux times the area, spread over a support
/// radius.
///
/// Not for walls thinner than a support radius.
///
/// Source: the surface as the gradient of a colour function, as in Brackbill, Kothe and Zemach (1992); the factor, own.
template <class Kernel = WendlandC2>
struct HeatFromWalls {
    using Prepared = PreparedHeatFlux;
    struct Sum { // a: heated particle, b: wall
        using reads = Fields<volume, heat_flux>;
        using adds = Fields<heated_surface, surface_heating>;

        IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
            const auto weight = b[volume] * ab.gradient(Kernel{});
            return values(along(ab, weight), along(ab, weight * b[heat_flux]));
        }
    };
    struct Heat {
        using reads = Fields<mass, volume, heated_surface, surface_heating>;
        using adds = Fields<enthalpy_rate>;
        static constexpr bool in_packs = true;
        Prepared prepared{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            const auto& g = a[heated_surface];
            return prepared.factor * a[volume] / a[mass] * dot(a[surface_heating], g) /
                   max(sqrt(squared_norm(g)), 1e-30);
        }
    };
    using parts = Parts<Volume, Sum, Heat>;

    /// The factor.
    template <int dim>
    static Prepared prepare(const auto&, const auto&, const Lattice<dim>& lattice) {
        const double all =
            lattice.volume() * lattice.sum([](const auto& ab) { return -sq(ab.distance) * ab.gradient(Kernel{}); });
        return {.factor = 2 * dim / all};
    }
};

} // namespace imbibe
