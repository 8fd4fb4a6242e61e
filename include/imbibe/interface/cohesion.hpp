// The surface tension of one liquid without a gas around it, and its contact angle at walls and solids.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/lattice.hpp>
#include <imbibe/core/method.hpp>
#include <imbibe/core/term.hpp>
#include <imbibe/fluid/summation_density.hpp>
#include <imbibe/fluid/symmetric_pressure.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/state/wave_speed.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <string_view>
#include <type_traits>

namespace imbibe {

/// kappa of Cohesion, Pa, for Adhesion to read.
struct CohesionStrength : Field<Rank::scalar> {
    static constexpr std::string_view name = "cohesion_strength", unit = "Pa";
};
inline constexpr CohesionStrength cohesion_strength{};

/// Coefficients of CohesivePressure and Cohesion.
struct CohesionParameters {
    /// sigma, N/m (water and air 0.072); 0: none
    double surface_tension = 0;

    /// Throws Error for a number out of range. @param where the phase in the message
    void check(std::string_view where) const {
        require_not_negative(surface_tension, where, "CohesionParameters::surface_tension", "N/m");
    }
};

/// What Cohesion and CohesivePressure compute of the surface tension.
struct PreparedCohesion {
    double strength = 0; ///< kappa, Pa
    double inner = 0;    ///< p_i, Pa
};

struct CohesivePressure;
struct Cohesion;
struct CohesiveContact;
struct Adhesion;

namespace detail {

// Constants of Cohesion, all for WendlandC6: they hold at any spacing, for these reaches alone. Lattices of most other
// reaches resist shear (Lattice::shear_stiffness) under p_i: drops then swing too fast and stick.
struct CohesionConstants {
    static constexpr double support = 5;      // of density and pressure, spacings
    static constexpr double reach = 6.25;     // of the pull, spacings
    static constexpr double tension = 0.0955; // sigma/(kappa spacing) of plane films, in 2D and 3D
};

// kappa, and the pressure of a lattice under it.
template <int dim>
PreparedCohesion prepared_cohesion(const auto& material, const CohesionParameters& parameters) {
    using Constants = CohesionConstants;
    const auto virial = [&](double spacings) { // - sum V x.grad W/dim, near 1
        const Lattice<dim> lattice{material.spacing, spacings * material.spacing};
        return -lattice.volume() / dim *
               lattice.sum([](const auto& ab) { return ab.gradient(WendlandC6{}) * squared_norm(ab.offset); });
    };
    const double strength = parameters.surface_tension / (Constants::tension * material.spacing);
    return {.strength = strength, .inner = 0.5 * strength * virial(Constants::reach) / virial(Constants::support)};
}

// Throws Error if something of CohesiveFluid is missing.
template <class Fluid>
void check_cohesive(const Fluid&, std::string_view where) {
    using Terms = typename Fluid::terms;
    require(
        contains<CohesivePressure, Terms> && contains<Cohesion, Terms> &&
            contains<SummationDensity<WendlandC6>, Terms> && contains<SymmetricPressure<WendlandC6>, Terms>,
        where,
        ": one of CohesivePressure, Cohesion, SummationDensity<WendlandC6> and SymmetricPressure<WendlandC6> without "
        "the others; list the method CohesiveFluid, which has all of them");
}
// Throws Error if something of its coupling is missing.
template <class Coupling>
void check_wetting(const Coupling&, std::string_view where) {
    using Terms = typename Coupling::terms;
    using First = typename Coupling::First;
    using Liquid = std::conditional_t<is_fluid<First>, First, typename Coupling::Second>;
    require(
        contains<CohesiveContact, Terms> && contains<Adhesion, Terms> &&
            contains<Into<Liquid, SummationNeighbours<WendlandC6>>, Terms>,
        where,
        ": one of CohesiveContact, Adhesion and, Into the liquid, SummationNeighbours<WendlandC6> without the others; "
        "take CouplingOf a fluid with the method CohesiveFluid, which has all of them");
}

// V_a V_b/m_a of a pair times the gradient of the kernel, m^2/kg (m/kg in 2D) without the offset.
IMBIBE_INLINE constexpr auto slope(const auto& a, const auto& b, const auto& ab) {
    return b[mass] * (1 / (a.material.density * b.material.density)) * ab.gradient(WendlandC6{});
}
// That of two materials, or of two particles, which is the liquid.
template <class A, class B>
constexpr const auto& liquid_among(const A& a, const B& b) {
    if constexpr (is_fluid<A>)
        return a;
    else
        return b;
}
IMBIBE_INLINE constexpr const auto& liquid_of(const auto& a, const auto& b) {
    if constexpr (is_fluid<typename std::remove_cvref_t<decltype(a)>::Material>)
        return a;
    else
        return b;
}

} // namespace detail

/// p = p_i (rho/rho_0)^4 + c^2 max(rho - rho_0, 0), in Pa: an equation of state for a liquid with Cohesion. Never
/// negative. Below rho_0 only the first part acts, so the tension does not depend on c. At rho_0 it equals the pull of
/// the neighbours: p_i is 5.2 sigma/spacing.
///
/// The pressure of the liquid is what is left of p without that pull: LiquidPressure.
///
/// Not without Cohesion (an error). Its energy is not among those that `energies` adds up: half of it is that of pairs.
///
/// Source: own; pressure and cohesion of different range, Nugent and Posch (2000).
struct CohesivePressure {
    using Parameters = CohesionParameters;
    using Prepared = PreparedCohesion;
    struct Set {
        using reads = Fields<density>;
        using sets = Fields<pressure>;
        static constexpr bool in_packs = true;
        Prepared prepared{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            const auto& material = a.material;
            return prepared.inner * sq(sq(a[density] / material.density)) +
                   sq(material.sound_speed) * positive_part(a[density] - material.density);
        }
    };
    using parts = Parts<Set>;

    /// p_i.
    template <int dim>
    static Prepared prepare(const auto& material, const Lattice<dim>&, const Parameters& parameters) {
        return detail::prepared_cohesion<dim>(material, parameters);
    }

    /// Throws Error without Cohesion. @param owner the fluid, @param where its name in the message
    static void check(const auto& owner, std::string_view where) { detail::check_cohesive(owner, where); }

    static constexpr const char* limit_name = "sound";
    /// That of sound with c^2 + 3 kappa/rho_0 in place of c^2, s: the slope of p and of the pull at the surface.
    static double time_step_limit(const auto& material, const TimeStepInput& in, const Parameters& parameters) {
        const double strength = parameters.surface_tension / (detail::CohesionConstants::tension * in.spacing);
        return acoustic_time_step(std::sqrt(sq(material.sound_speed) + 3 * strength / material.density), in);
    }
};

/// dv_a/dt = kappa/m_a sum_b V_a V_b grad_a W_ab, in m/s^2, with the volumes V = m/rho_0, W WendlandC6 with a support
/// of 6.25 spacings, and kappa = 10.5 sigma/spacing: each pair attracts. Inside the liquid CohesivePressure balances
/// that; at its surface the particles inside pull those outside, which is the surface tension sigma. Equal and
/// opposite: momentum is conserved exactly.
///
/// In a fluid with CohesivePressure, SummationDensity<WendlandC6> and SymmetricPressure<WendlandC6> (an error if not);
/// the method CohesiveFluid lists them. All follow from one energy of the positions. With these supports a lattice of
/// particles hardly resists shear, so drops flow as a liquid does.
///
/// The fluid's support radius is 5 spacings (an error if not): kappa holds for that alone, at any spacing.
/// docs/validation.md has the accuracy (free-drop, free-ball). The outermost particles lie closer along the surface
/// than across it; a start on a lattice releases energy until they do: see settle_surface.
///
/// Not for films thinner than 6 spacings, whose two surfaces feel each other. Drops of fewer than some 20 particles
/// contract to a point, and stay pairs in what they meet, unless KernelRepulsion with a range of half a spacing and a
/// stiffness of 0.05 sigma/spacing stands beside it, as in presets::WettingLiquid. Not with a second liquid:
/// InterfaceTension.
///
/// Source: own, with a constant found on plane films (tests/terms/test_cohesion.cpp). Attraction by pairs: Nugent and
/// Posch (2000), Tartakovsky and Meakin (2005).
struct Cohesion : NotStiff { // CohesivePressure limits the step
    using Parameters = CohesionParameters;
    using Prepared = PreparedCohesion;
    static constexpr bool within_phases = true;
    struct Strength {
        using reads = Fields<mass>;
        using sets = Fields<cohesion_strength>;
        static constexpr bool in_packs = true;
        Prepared prepared{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const { return 0 * a[mass] + prepared.strength; }
    };
    struct Pull {
        using reads = Fields<mass>;
        using adds = Fields<acceleration>;
        Prepared prepared{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            return along(ab, prepared.strength * detail::slope(a, b, ab));
        }
    };
    using parts = Parts<Strength, Pull>;

    /// 6.25 spacings, m.
    static double support_radius(const auto& material) { return detail::CohesionConstants::reach * material.spacing; }
    /// kappa.
    template <int dim>
    static Prepared prepare(const auto& material, const Lattice<dim>&, const Parameters& parameters) {
        return detail::prepared_cohesion<dim>(material, parameters);
    }
    /// Throws Error if the support radius is not 5 spacings or what belongs to it is missing. @param owner the fluid,
    /// @param where its name in the message
    static void check(const auto& owner, std::string_view where) {
        detail::check_cohesive(owner, where);
        const double given = owner.support_radius / owner.spacing, needed = detail::CohesionConstants::support;
        require(!(owner.spacing > 0) || std::abs(given - needed) < 0.01, where, ": a support radius of ", given,
                " spacings beside Cohesion; it must be ", needed, " spacings, for which its constants hold");
    }
};

/// dv_a/dt = - 1/m_a sum_b V_a V_b (P + kappa/2) grad_a W_ab, in m/s^2, with P = p (rho_0/rho)^2 of the liquid of the
/// pair and the volumes V = m/rho_0: the pressure between a liquid with Cohesion and a wall or a solid, in their
/// coupling, beside Adhesion and, `Into` the liquid, SummationNeighbours. Equal and opposite: it pushes solids too.
///
/// The wall's particles count in the liquid's density: this gives P. The wall adds kappa/2, the pressure of a liquid at
/// rest. With Adhesion both derive from an energy of the positions: still walls neither add energy nor take any, and
/// with solids none is lost. Under a pressure of some kappa/2 the lowest particles lie half a spacing deeper.
///
/// Not without the others (an error).
///
/// Source: own.
struct CohesiveContact {
    static constexpr bool between_fluid_and_other = true;
    struct Push {
        using reads = Fields<mass, cohesion_strength, pressure_over_density2>;
        using adds = Fields<acceleration>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const auto& liquid = detail::liquid_of(a, b);
            const auto P = sq(liquid.material.density) * liquid[pressure_over_density2];
            return along(ab, -(P + 0.5 * liquid[cohesion_strength]) * detail::slope(a, b, ab));
        }
    };
    using parts = Parts<Push>;

    /// Throws Error if what belongs to it is missing. @param coupling of a liquid and a wall or solid, @param where its
    /// name in the message
    static void check(const auto& coupling, std::string_view where) { detail::check_wetting(coupling, where); }

    static constexpr const char* limit_name = "pressure between phases";
    /// That of interface_time_step, s.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in) {
        return interface_time_step(material_a, material_b, in);
    }
};

/// Coefficients of Adhesion.
struct AdhesionParameters {
    /// theta, rad, measured in the liquid, from 30 to 150 degrees
    double contact_angle = 0.5 * std::numbers::pi;

    /// Throws Error for a number out of range. @param where the coupling in the message
    void check(std::string_view where) const {
        const double degrees = contact_angle * (180 / std::numbers::pi);
        require(degrees > 29.99 && degrees < 150.01, where, ": AdhesionParameters::contact_angle = ", contact_angle,
                " rad; it must be from 0.524 rad (30 degrees) to 2.618 rad (150 degrees), for which Adhesion was "
                "measured: take these for a liquid that wets more or less; degrees are multiplied by pi/180");
    }
};

/// What Adhesion computes of its angle.
struct PreparedAdhesion {
    double share = 0; ///< s
};

/// dv_a/dt = s kappa/m_a sum_b V_a V_b grad_a W_ab, in m/s^2, with kappa, V and W of Cohesion: the pull between a
/// liquid with Cohesion and a wall or a solid, in their coupling. Equal and opposite: it pulls solids too.
///
/// s rises from 0.47 at 150 degrees over 0.86 at 90 to 1.08 at 30, by the angles of drops of 36 spacings a radius, in
/// the plane. Lines that advance and lines that recede come to rest within 5 degrees of each other from 80 degrees on.
/// Below 70 degrees a line that recedes stops up to 20 degrees lower: there the lowest particles lie between those of
/// the wall. TwoLiquids with a gas has no such difference, at twice the particles. docs/validation.md has the accuracy
/// (wetting-drop, wetting-rise).
///
/// Not for walls and solids thinner than 6.25 spacings, nor (an error) coarser than the liquid.
///
/// Source: own, with measured s. That adhesion sets the angle: Young (1805), Dupre (1869).
struct Adhesion : NotStiff { // CohesivePressure limits the step
    using Parameters = AdhesionParameters;
    using Prepared = PreparedAdhesion;
    static constexpr bool between_fluid_and_other = true;
    struct Pull {
        using reads = Fields<mass, cohesion_strength>;
        using adds = Fields<acceleration>;
        Prepared prepared{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            return along(ab, prepared.share * detail::liquid_of(a, b)[cohesion_strength] * detail::slope(a, b, ab));
        }
    };
    using parts = Parts<Pull>;

    /// 6.25 spacings of the liquid, m.
    static double support_radius(const auto& material_a, const auto& material_b) {
        return Cohesion::support_radius(detail::liquid_among(material_a, material_b));
    }
    /// Throws Error if what belongs to it is missing. @param coupling of a liquid and a wall or solid, @param where its
    /// name in the message
    static void check(const auto& coupling, std::string_view where) { detail::check_wetting(coupling, where); }
    /// s. Throws Error for a wall or a solid that is coarser than the liquid.
    template <int dim>
    static Prepared prepare(const auto& material_a, const auto& material_b, const Lattice<dim>&,
                            const Parameters& parameters) {
        const double coarser = std::max(material_a.spacing, material_b.spacing),
                     liquid = detail::liquid_among(material_a, material_b).spacing;
        require(coarser < 1.01 * liquid, "Adhesion: a wall or solid with a spacing of ", coarser,
                " m at a liquid with one of ", liquid, " m; place it with a spacing of at most that");
        return {.share = share_at(parameters.contact_angle * (180 / std::numbers::pi))};
    }

private:
    // s at an angle, degrees, on straight lines between pairs measured as in cases/validation/wetting_drop.hpp: the
    // mean of two starts, in the plane.
    static double share_at(double degrees) {
        static constexpr double angles[] = {150.8, 147.1, 141.3, 132.2, 119.2, 101.9, 92.6,
                                            81.4,  69.8,  55.9,  45.4,  34.2,  29.2},
                                shares[] = {0.47, 0.5, 0.55, 0.6, 0.7, 0.8, 0.85, 0.9, 0.95, 1.0, 1.03, 1.06, 1.08};
        std::size_t i = 1;
        while (i + 1 < std::size(angles) && angles[i] > degrees)
            ++i;
        return shares[i - 1] + (shares[i] - shares[i - 1]) * (angles[i - 1] - degrees) / (angles[i - 1] - angles[i]);
    }
};

} // namespace imbibe
