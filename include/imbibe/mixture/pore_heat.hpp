// Heat in pores too small to resolve: of the fluid that fills them, and between it and the skeleton.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/lattice.hpp>
#include <imbibe/fluid/volume.hpp>
#include <imbibe/heat/conduction.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/mixture/porous_skeleton.hpp>

#include <cmath>
#include <limits>
#include <string_view>

namespace imbibe {

/// HeatConduction of a fluid with InPores: the conductivity counts for the fluid's share n of the space, n c_a in place
/// of the correction c_a. Outside the skeleton it is HeatConduction.
///
/// In the fluid, beside HeatCapacity or Melting. The skeleton has HeatConduction with `Reference`, and the conductivity
/// of the dry skeleton in all of its volume. Together they conduct n k_f + k_s, side by side.
///
/// Not for pores that force the heat through fluid and skeleton in turns: give the skeleton a conductivity with which
/// the sum is right.
///
/// Source: that of HeatConduction; volume averages, Whitaker (1977).
template <class Kernel = WendlandC2>
struct PoreHeatConduction {
    using Open = HeatConduction<Kernel>; ///< of a fluid outside
    static constexpr bool within_phases = true;
    using Prepared = PreparedConduction;
    struct Correct {
        using reads = Fields<conduction_moment, conduction_stiffness, porosity>;
        using sets = Fields<conduction_correction>;
        static constexpr bool in_packs = true;
        Prepared prepared{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            return a[porosity] * typename Open::Correct{prepared}(a);
        }
    };
    using parts = Parts<Volume, typename Open::Moment, Correct, typename Open::Conduct>;

    /// Of the scene's lattice.
    template <int dim>
    static Prepared prepare(const auto& material, const Lattice<dim>& lattice) {
        return Open::prepare(material, lattice);
    }

    static constexpr const char* limit_name = Open::limit_name;
    /// That of HeatConduction, s: in pores the fluid has n of the conductivity and n of the mass.
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        return Open::time_step_limit(material, in);
    }
};

/// Coefficients of PoreHeatExchange.
struct PoreHeatExchangeParameters {
    /// h, W/(m^3 K): the heat that flows per volume and difference of the temperatures. 0: (k_f + k_s)/spacing^2, so
    /// that the two are as warm as each other over a spacing. Beads of the diameter d in a liquid at rest: 60 (1 - n)
    /// k/d^2.
    double exchange = 0;

    /// Throws Error for a number out of range. @param where the coupling in the message
    void check(std::string_view where) const {
        require_not_negative(exchange, where, "PoreHeatExchangeParameters::exchange", "W/(m^3 K)");
    }
};

/// What PoreHeatExchange computes of the two materials and the lattice.
struct PreparedPoreHeatExchange {
    double constant = 0;  ///< h alpha, W/(m^3 K)
    double quadratic = 0; ///< h beta/H^2, W/(m^5 K)
};

namespace detail {
// h of PoreHeatExchange, W/(m^3 K). @param spacing of the two, m
inline double pore_heat_exchange(const auto& material_a, const auto& material_b, double spacing,
                                 const PoreHeatExchangeParameters& parameters) {
    const double k = greatest_conductivity(material_a, 0) + greatest_conductivity(material_b, 0);
    return parameters.exchange > 0 ? parameters.exchange : 0.5 * k / sq(spacing);
}
} // namespace detail

/// dh_a/dt = h/m_a sum_b V_a V_b W_ab (alpha - beta |x_ab|^2/H^2) (T_b - T_a), in W/kg, between a fluid's particles and
/// those of the skeleton whose pores it fills, with their volumes V in all of the space. What one gives the other
/// takes. alpha and beta are such that the weights add up to 1 and their second moment is 0 over a lattice: with W
/// alone heat would spread by h H^2/14 in the plane, which is as much as it is conducted.
///
/// In the coupling of a fluid with InPores and a skeleton with PorousSkeleton, which both have HeatCapacity or Melting.
///
/// Not between bodies that touch at a surface: HeatTransfer.
///
/// Source: two temperatures, Schumann (1929); 60 (1 - n) k/d^2, Wakao and Kaguei (1982) with Nu = 2 and more at rest.
template <class Kernel = WendlandC2>
struct PoreHeatExchange {
    static constexpr bool between_fluid_and_other = true;
    static constexpr bool overlapping = true; ///< no warning that the two are in the same place
    using Parameters = PoreHeatExchangeParameters;
    using Prepared = PreparedPoreHeatExchange;
    struct Flow {
        using reads = Fields<mass, volume, temperature>;
        using adds = Fields<enthalpy_rate>;
        Prepared prepared{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const auto weight = prepared.constant - prepared.quadratic * squared_norm(ab.offset);
            return (weight * a[volume] * b[volume] / a[mass] * ab.value(Kernel{})) * (b[temperature] - a[temperature]);
        }
    };
    using parts = Parts<Volume, Flow>;

    /// Of the two materials and the scene's lattice.
    template <int dim>
    static Prepared prepare(const auto& material_a, const auto& material_b, const Lattice<dim>& lattice,
                            const Parameters& parameters) {
        const double h = detail::pore_heat_exchange(material_a, material_b, lattice.spacing, parameters);
        double moments[3]{lattice.volume() *
                          Pair<dim, double>({}, 0, SupportRadius(lattice.support_radius), {}).value(Kernel{})};
        for (int k = 0; k < 3; ++k)
            moments[k] += lattice.volume() * lattice.sum([&](const auto& ab) {
                return std::pow(ab.distance / lattice.support_radius, 2 * k) * ab.value(Kernel{});
            });
        // alpha m_0 - beta m_1 = 1, alpha m_1 - beta m_2 = 0
        const double determinant = moments[0] * moments[2] - sq(moments[1]);
        if (!(determinant > 0))
            return {}; // neighbours are out of reach
        return {.constant = h * moments[2] / determinant,
                .quadratic = h * moments[1] / (determinant * sq(lattice.support_radius))};
    }

    static constexpr const char* limit_name = "pore heat exchange";
    /// 2/(h/(n_0 rho_f c_f) + h/(rho_s c_s)), s, with the porosity n_0 and the density rho_s of the dry skeleton.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in,
                                  const Parameters& parameters) {
        const double h = detail::pore_heat_exchange(material_a, material_b, in.spacing, parameters);
        double rate = 0;
        const auto add = [&](const auto& material) {
            const double share = detail::is_fluid<std::remove_cvref_t<decltype(material)>>
                                     ? detail::skeleton_of(material_a, material_b).porosity
                                     : 1;
            detail::with_heat_law(
                material, [&](const auto& law) { rate += h / (share * material.density * law.least_heat_capacity()); });
        };
        add(material_a);
        add(material_b);
        return rate > 0 ? 2 / rate : std::numeric_limits<double>::infinity();
    }
};

} // namespace imbibe
