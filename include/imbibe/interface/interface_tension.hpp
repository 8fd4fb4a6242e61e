// The tension of the interface between two fluids, and its contact angle at a wall or a solid.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/lattice.hpp>
#include <imbibe/core/term.hpp>
#include <imbibe/fluid/volume.hpp>
#include <imbibe/kernels/wendland.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <type_traits>

namespace imbibe {

/// sigma sum_b V_b grad_a W_ab over the particles b of the other fluid, Pa.
struct InterfaceGradient : Field<Rank::vector> {
    static constexpr std::string_view name = "interface_gradient", unit = "Pa";
    static constexpr bool shown = true;
};
inline constexpr InterfaceGradient interface_gradient{};

/// sum_b V_b grad_a W_ab over the particles b of walls and solids, 1/m.
struct SolidGradient : Field<Rank::vector> {
    static constexpr std::string_view name = "solid_gradient", unit = "1/m";
};
inline constexpr SolidGradient solid_gradient{};

/// sum_b cos(theta) V_b grad_a W_ab over the same, with the contact angle theta of each, 1/m.
struct WettingGradient : Field<Rank::vector> {
    static constexpr std::string_view name = "wetting_gradient", unit = "1/m";
};
inline constexpr WettingGradient wetting_gradient{};

/// sum_b V_b W_ab over the same, without unit: the share of the kernel that lies in walls and solids.
struct SolidShare : Field<Rank::scalar> {
    static constexpr std::string_view name = "solid_share", unit = "1";
};
inline constexpr SolidShare solid_share{};

/// The direction of solid_gradient.
struct SolidDirection : Field<Rank::vector> {
    static constexpr std::string_view name = "solid_direction", unit = "1";
};
inline constexpr SolidDirection solid_direction{};

/// The pull of walls and solids at the contact line of two fluids, Pa.
struct ContactLinePull : Field<Rank::vector> {
    static constexpr std::string_view name = "contact_line_pull", unit = "Pa";
    static constexpr bool shown = true;
};
inline constexpr ContactLinePull contact_line_pull{};

/// The stress of the interface, Pa.
struct InterfaceStressField : Field<Rank::symmetric_tensor> {
    static constexpr std::string_view name = "interface_stress", unit = "Pa";
};
inline constexpr InterfaceStressField interface_stress{};

/// dv_a/dt = 1/m_a sum_b V_a V_b (T_a + T_b) grad_a W_ab, in m/s^2, with the volumes V = m/rho and the stress T of
/// InterfaceTension. Equal and opposite: momentum is conserved exactly.
///
/// In each of the fluids, and in their coupling beside InterfaceTension.
///
/// Not without a pressure that outweighs the tension, UnderPressure: particles would form clumps. Not with walls and
/// solids: their action on the interface is ContactLineForce.
///
/// Source: Hu and Adams (2006).
template <class Kernel = WendlandC2>
struct InterfaceForce : NotStiff { // InterfaceTension limits the step
    static constexpr bool between_fluids = true;
    struct Pull {
        using reads = Fields<mass, volume, interface_stress>;
        using adds = Fields<acceleration>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            return (a[volume] * b[volume] / a[mass] * ab.gradient(Kernel{})) *
                   ((a[interface_stress] + b[interface_stress]) * ab.offset);
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

/// G_a = sigma sum_b V_b grad_a W_ab, in Pa, over the particles b of the other fluid, and the stress T_a = |G_a| 1 -
/// G_a (x) G_a/|G_a|, in Pa: a tension along the interface and none across it. In the coupling of two fluids, beside
/// InterfaceForce. Inside a fluid G is exactly 0, however its particles lie; across an interface |G| sums up to sigma,
/// half of it in each fluid.
///
/// docs/validation.md has the accuracy of waves (capillary-wave), drops (sessile-drop) and bubbles (rising-bubble).
///
/// Not for a liquid without a second fluid around it: give it a gas of a hundredth of its density. Not for three fluids
/// that meet: where two interfaces of one fluid come near each other, it has only one G.
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
            using T = typename std::remove_cvref_t<decltype(a)>::Scalar;
            constexpr int dim = std::remove_cvref_t<decltype(a)>::dimension;
            const auto& G = a[interface_gradient];
            const T length = sqrt(squared_norm(G));
            return length * symmetric_identity<T, dim>() - symmetric_part(outer((1 / max(length, 1e-30)) * G, G));
        }
    };
    using parts = Parts<Volume, Sum, Stress>;

    /// Throws Error if the stress would act between the fluids and not within them. @param coupling of the two, @param
    /// where its name in the message
    static void check(const auto& coupling, std::string_view where) {
        using Between = std::remove_cvref_t<decltype(coupling)>;
        using Force = InterfaceForce<Kernel>;
        require(detail::contains<Force, typename Between::terms> &&
                    detail::contains<Force, typename Between::First::terms> &&
                    detail::contains<Force, typename Between::Second::terms>,
                where,
                ": InterfaceTension without InterfaceForce of the same kernel in this coupling and in both fluids; ",
                "list it in all three (the method CapillaryFluid does)");
    }

    static constexpr const char* limit_name = "interface tension";
    /// 0.4 sqrt(rho dx^3/sigma), s, with the mean density of the two: capillary waves of two particles' length.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in,
                                  const Parameters& parameters) {
        if (parameters.surface_tension == 0)
            return std::numeric_limits<double>::infinity();
        return 0.4 * std::sqrt(0.5 * (material_a.density + material_b.density) *
                               power<3>(std::min(in.spacing, in.other_spacing)) / parameters.surface_tension);
    }
};

/// Coefficients of ContactAngle.
struct ContactAngleParameters {
    /// theta, rad, measured in the fluid that the term acts into: that of the other fluid is pi - theta
    double contact_angle = 0.5 * std::numbers::pi;

    /// Throws Error for a number out of range. @param where the coupling in the message
    void check(std::string_view where) const {
        require(contact_angle >= 0 && contact_angle <= std::numbers::pi, where,
                ": ContactAngleParameters::contact_angle = ", contact_angle,
                " rad; it must be from 0 (wets fully) to pi (does not wet); degrees are multiplied by pi/180");
    }
};

/// What ContactAngle computes of its angle.
struct PreparedContactAngle {
    double cosine = 1; ///< cos theta
};

/// The pull at the contact line, in Pa,
///
///     f_a = 2/(1 - s_a) (c_a G_t + |G_t|^2/|G_a| n_a),    G_t = (1 - n_a (x) n_a) G_a,
///
/// with G of InterfaceTension, the share s_a = sum_b V_b W_ab of walls and solids and their direction n_a, that of g_a
/// = sum_b V_b grad_a W_ab, and c_a = cos theta, their mean where there are several. `Into` each of the two fluids, in
/// its coupling with the wall or solid, beside ContactLineForce.
///
/// Along the surface the line is pulled with sigma cos theta per length, towards the other fluid if theta is below 90
/// degrees: at rest that balances the interface at the angle theta (Young 1805). In the direction into the solid it is
/// held against the interface that pulls it off, at any angle to the surface: |G_t|/|G_a| is its sine. Without this
/// second part a gap opens at the line.
///
/// The sums of |g| over the fluids' particles give 1/2 per area of the surface, and those of G along it (1 - s) sigma,
/// which makes the factor. s is limited to 1/2, its value at a flat surface. docs/validation.md has the results
/// (sessile-drop, capillary-rise, capillary-tube).
///
/// Not for walls and solids thinner than a support radius, or with channels narrower than two.
///
/// Source: own; a line force from two gradients, Huber, Keller, Saeckel, Hirschler, Kunz, Hassanizadeh and Nieken
/// (2016).
template <class Kernel = WendlandC2>
struct ContactAngle {
    using Parameters = ContactAngleParameters;
    using Prepared = PreparedContactAngle;
    static constexpr bool between_fluid_and_other = true;
    struct Sum {
        using reads = Fields<volume>;
        using adds = Fields<solid_gradient, wetting_gradient, solid_share>;
        Prepared prepared{};

        IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
            const auto weight = b[volume] * ab.gradient(Kernel{});
            return values(along(ab, weight), along(ab, prepared.cosine * weight), b[volume] * ab.value(Kernel{}));
        }
    };
    struct Line {
        using reads = Fields<solid_gradient, wetting_gradient, solid_share, interface_gradient>;
        using sets = Fields<solid_direction, contact_line_pull>;
        static constexpr bool in_packs = true;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            const auto& g = a[solid_gradient];
            const auto& G = a[interface_gradient];
            // Of a neighbour at the very rim of the support no direction is left in float: n is then shorter than 1.
            const auto shortened = 1 / max(sqrt(squared_norm(g)), 1e-6 / a.material.support_radius);
            const auto n = shortened * g;
            const auto cosine = shortened * dot(n, a[wetting_gradient]);
            const auto G_t = G - dot(n, G) * n;
            const auto held = squared_norm(G_t) / max(sqrt(squared_norm(G)), 1e-30);
            const auto outside = max(1 - a[solid_share], 0.5); // what a flat surface leaves of the kernel
            return values(n, (2 / outside) * (cosine * G_t + held * n));
        }
    };
    using parts = Parts<Volume, Sum, Line>;

    /// The cosine.
    template <int dim>
    static Prepared prepare(const auto&, const auto&, const Lattice<dim>&, const Parameters& parameters) {
        return {.cosine = std::cos(parameters.contact_angle)};
    }
};

/// dv_a/dt = 1/m_a sum_b V_a V_b (n . grad_a W_ab) f, in m/s^2, with n and f of ContactAngle from the fluid of the
/// pair: V_a |g_a| f_a is the force on a fluid's particle. Equal and opposite: it pulls solids too.
///
/// In the coupling of each of two fluids with a wall or solid, beside ContactAngle `Into` the fluid.
///
/// Not without InterfaceTension between the fluids.
///
/// Source: own, see ContactAngle.
template <class Kernel = WendlandC2>
struct ContactLineForce : NotStiff { // InterfaceTension limits the step
    static constexpr bool between_fluid_and_other = true;
    struct Pull {
        using reads = Fields<mass, volume, solid_direction, contact_line_pull>;
        using adds = Fields<acceleration>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const auto weight = a[volume] * b[volume] / a[mass] * ab.gradient(Kernel{});
            if constexpr (detail::is_fluid<typename std::remove_cvref_t<decltype(a)>::Material>)
                return (weight * dot(a[solid_direction], ab.offset)) * a[contact_line_pull];
            else
                return (weight * dot(b[solid_direction], ab.offset)) * b[contact_line_pull];
        }
    };
    using parts = Parts<Volume, Pull>;
};

} // namespace imbibe
