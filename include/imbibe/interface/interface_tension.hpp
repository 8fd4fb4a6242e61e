// The tension of the interface between two fluids, and the angle at which it meets a wall or a solid.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/term.hpp>
#include <imbibe/fluid/volume.hpp>
#include <imbibe/kernels/wendland.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

namespace imbibe {

/// sigma sum_b V_b grad_a W_ab over the particles b of the other fluid, Pa.
struct InterfaceGradient : Field<Rank::vector> {
    static constexpr std::string_view name = "interface_gradient", unit = "Pa";
    static constexpr bool shown = true;
};
inline constexpr InterfaceGradient interface_gradient{};

/// 2 sigma_s sum_b V_b grad_a W_ab over the particles b of walls and solids, Pa.
struct WettingGradient : Field<Rank::vector> {
    static constexpr std::string_view name = "wetting_gradient", unit = "Pa";
    static constexpr bool shown = true;
};
inline constexpr WettingGradient wetting_gradient{};

/// The stress of the interfaces of a fluid, Pa.
struct InterfaceStressField : Field<Rank::symmetric_tensor> {
    static constexpr std::string_view name = "interface_stress", unit = "Pa";
};
inline constexpr InterfaceStressField interface_stress{};

namespace detail {
// |G| 1 - G (x) G/|G|, Pa: a tension along the interface whose gradient G is, and none across it.
template <class T, int dim>
IMBIBE_INLINE constexpr auto stress_along(const Vector<T, dim>& G) {
    const T length = sqrt(squared_norm(G));
    return length * symmetric_identity<T, dim>() - symmetric_part(outer((1 / max(length, 1e-30)) * G, G));
}
// The sum of the stresses of a pair, Pa: a wall or a solid has none of its own.
IMBIBE_INLINE constexpr auto stress_of_both(const auto& a, const auto& b) {
    using A = typename std::remove_cvref_t<decltype(a)>::Material;
    using B = typename std::remove_cvref_t<decltype(b)>::Material;
    if constexpr (is_fluid<A> && is_fluid<B>)
        return a[interface_stress] + b[interface_stress];
    else if constexpr (is_fluid<A>)
        return a[interface_stress];
    else
        return b[interface_stress];
}
// 0.4 sqrt(rho dx^3/sigma), s; infinite without a tension.
inline double capillary_limit(double density, double spacing, double tension) {
    return tension > 0 ? 0.4 * std::sqrt(density * sq(spacing) * spacing / tension)
                       : std::numeric_limits<double>::infinity();
}
} // namespace detail

/// dv_a/dt = 1/m_a sum_b V_a V_b (T_a + T_b) grad_a W_ab, in m/s^2, with the volumes V = m/rho and the stress T of
/// InterfaceTension and Wetting; a wall or a solid has none. Equal and opposite: momentum is conserved exactly, and
/// solids are pulled at.
///
/// In each of the fluids, in their coupling beside InterfaceTension, and in their couplings with walls and solids, beside
/// Wetting or alone.
///
/// Not without a pressure that outweighs the tension, UnderPressure: particles would form clumps.
///
/// Source: Hu and Adams (2006).
template <class Kernel = WendlandC2>
struct InterfaceForce : NotStiff { // InterfaceTension and Wetting limit the step
    struct Pull {
        using reads = Fields<mass, volume, interface_stress>;
        using adds = Fields<acceleration>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            return (a[volume] * b[volume] / a[mass] * ab.gradient(Kernel{})) *
                   (detail::stress_of_both(a, b) * ab.offset);
        }
    };
    using parts = Parts<Volume, Pull>;
};

/// Coefficients of InterfaceTension.
struct InterfaceTensionParameters {
    /// sigma, N/m (water and air 0.072, water and oil about 0.03); 0: none
    double surface_tension = 0;

    /// Throws Error for a number out of range. @param where the coupling in the message
    void check(std::string_view where) const {
        require_not_negative(surface_tension, where, "InterfaceTensionParameters::surface_tension", "N/m");
    }
};

/// G_a = sigma sum_b V_b grad_a W_ab, in Pa, over the particles b of the other fluid, and the stress T_a = |G_a| 1 - G_a
/// (x) G_a/|G_a|, in Pa: a tension along the interface and none across it. In the coupling of two fluids, beside
/// InterfaceForce. Inside a fluid G is exactly 0, however its particles lie; across an interface |G| sums up to sigma,
/// half of it in each fluid.
///
/// docs/validation.md says how right waves (capillary-wave), drops (sessile-drop) and bubbles (rising-bubble) are.
///
/// Not for a liquid without a second fluid around it. Not for three fluids that meet: where two interfaces of one fluid
/// come near each other, G is that of one.
///
/// Source: Lafaurie, Nardone, Scardovelli, Zaleski and Zanetti (1994) for the stress; Hu and Adams (2006), with the
/// colour of the other fluid alone.
template <class Kernel = WendlandC2>
struct InterfaceTension {
    using Parameters = InterfaceTensionParameters;
    static constexpr bool between_fluids = true;
    struct Sum {
        using reads = Fields<volume>;
        using adds = Fields<interface_gradient>;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
            return along(ab, parameters.surface_tension * b[volume] * ab.gradient(Kernel{}));
        }
    };
    struct Stress {
        using reads = Fields<interface_gradient>;
        using adds = Fields<interface_stress>;
        static constexpr bool in_packs = true;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            return detail::stress_along(a[interface_gradient]);
        }
    };
    using parts = Parts<Volume, Sum, Stress>;

    static constexpr const char* limit_name = "interface tension";
    /// 0.4 sqrt(rho dx^3/sigma), s, with the mean density of the two: capillary waves of two particles' length.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in,
                                  const Parameters& parameters) {
        return detail::capillary_limit(0.5 * (material_a.density + material_b.density),
                                       std::min(in.spacing, in.other_spacing), parameters.surface_tension);
    }
};

/// Coefficients of Wetting.
struct WettingParameters {
    /// sigma_s of the fluid against the wall or solid, N/m; see tensions_at_contact_angle
    double tension = 0;

    /// Throws Error for a number out of range. @param where the coupling in the message
    void check(std::string_view where) const {
        require_not_negative(tension, where, "WettingParameters::tension", "N/m");
    }
};

/// The tensions of a solid against two fluids.
struct WettingTensions {
    double liquid; ///< against the one in which the contact angle is measured, N/m
    double other;  ///< against the other one, N/m
};

/// The least tensions sigma_s of two fluids against a solid with which they meet it at a contact angle theta:
/// sigma_other - sigma_liquid = sigma cos theta.
/// @param surface_tension sigma of the two fluids, N/m @param contact_angle theta, rad, measured in the liquid
/// @throws Error unless the angle is from 0 to pi
///
/// Source: Young (1805).
inline WettingTensions tensions_at_contact_angle(double surface_tension, double contact_angle) {
    require_not_negative(surface_tension, "tensions_at_contact_angle", "surface_tension", "N/m");
    require(contact_angle >= 0 && contact_angle <= std::numbers::pi,
            "tensions_at_contact_angle: contact_angle = ", contact_angle,
            " rad; it must be from 0 (wets fully) to pi (does not wet); degrees are multiplied by pi/180");
    const double pull = surface_tension * std::cos(contact_angle);
    return {.liquid = std::max(0.0, -pull), .other = std::max(0.0, pull)};
}

/// G_a = 2 sigma_s sum_b V_b grad_a W_ab, in Pa, over the particles b of walls and solids, and the stress T_a of
/// InterfaceTension from it: the tension of the layer of fluid along them. `Into` the fluid, beside InterfaceForce, in the
/// coupling of each of two fluids with the wall or solid. Only the difference of their two tensions matters
/// (tensions_at_contact_angle): it drives the line in which all three meet. docs/validation.md, sessile-drop, has the
/// angles that come out.
///
/// Not for walls and solids thinner than a support radius.
///
/// Source: Hu and Adams (2006), who give the solid a tension against each fluid; that it acts in the fluid alone is own.
template <class Kernel = WendlandC2>
struct Wetting {
    using Parameters = WettingParameters;
    static constexpr bool between_fluid_and_other = true;
    struct Sum {
        using reads = Fields<volume>;
        using adds = Fields<wetting_gradient>;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
            return along(ab, 2 * parameters.tension * b[volume] * ab.gradient(Kernel{}));
        }
    };
    struct Stress {
        using reads = Fields<wetting_gradient>;
        using adds = Fields<interface_stress>;
        static constexpr bool in_packs = true;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            return detail::stress_along(a[wetting_gradient]);
        }
    };
    using parts = Parts<Volume, Sum, Stress>;

    static constexpr const char* limit_name = "wetting";
    /// 0.4 sqrt(rho dx^3/sigma_s), s.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in,
                                  const Parameters& parameters) {
        return detail::capillary_limit(std::min(material_a.density, material_b.density),
                                       std::min(in.spacing, in.other_spacing), parameters.tension);
    }
};

} // namespace imbibe
