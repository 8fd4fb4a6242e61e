// Heat conduction between particles, inside a phase and between phases.
#pragma once

#include <imbibe/core/lattice.hpp>
#include <imbibe/fluid/pairwise_laplacian.hpp>
#include <imbibe/fluid/volume.hpp>
#include <imbibe/heat/enthalpy.hpp>
#include <imbibe/kernels/wendland.hpp>

#include <algorithm>
#include <limits>
#include <string_view>
#include <type_traits>

namespace imbibe {

/// sum_b V_b |grad_a W_ab| |x_ab|/dim over all particles that exchange heat with it, without unit: 1 inside, 1/2 at an
/// insulated surface.
struct ConductionMoment : Field<Rank::scalar> {
    static constexpr std::string_view name = "conduction_moment", unit = "1";
};
inline constexpr ConductionMoment conduction_moment{};

/// sum_b V_b |grad_a W_ab|/|x_ab| H^2 over these and itself, without unit: the stiffness of the exchange.
struct ConductionStiffness : Field<Rank::scalar> {
    static constexpr std::string_view name = "conduction_stiffness", unit = "1";
};
inline constexpr ConductionStiffness conduction_stiffness{};

/// Correction for missing neighbours, without unit: 1 inside.
struct ConductionCorrection : Field<Rank::scalar> {
    static constexpr std::string_view name = "conduction_correction", unit = "1";
};
inline constexpr ConductionCorrection conduction_correction{};

namespace detail {
// The time step limit, s, of the particles of one phase that exchange heat with the conductivity k.
template <class Kernel>
double conduction_limit(const auto& material, double k, const TimeStepInput& in) {
    double limit = std::numeric_limits<double>::infinity();
    with_heat_law(material, [&](const auto& law) {
        limit = pairwise_diffusion_limit<Kernel>(k / (material.density * law.least_heat_capacity()), in);
    });
    return limit;
}

// A neighbour's contribution to the ConductionMoment and the ConductionStiffness.
template <class Kernel>
IMBIBE_INLINE constexpr auto conduction_sums(const auto& b, const auto& ab) {
    constexpr double dim = decltype(ab.offset)::size;
    const auto weight = -b[volume] * ab.gradient(Kernel{});
    return values((1 / dim) * squared_norm(ab.offset) * weight, sq(ab.support_radius) * weight);
}

// c_a + c_b of a pair; with a wall of prescribed temperature, twice that of the other.
IMBIBE_INLINE constexpr auto sum_of_corrections(const auto& a, const auto& b) {
    if constexpr (!holds_heat<typename std::remove_cvref_t<decltype(a)>::Material>)
        return 2 * b[conduction_correction];
    else if constexpr (!holds_heat<typename std::remove_cvref_t<decltype(b)>::Material>)
        return 2 * a[conduction_correction];
    else
        return a[conduction_correction] + b[conduction_correction];
}
} // namespace detail

/// The numbers that HeatConduction prepares from the lattice.
struct PreparedConduction {
    double per_stiffness = 0; ///< 1/1.3 over its ConductionStiffness
};

/// dh_a/dt = 1/m_a sum_b V_a V_b (c_a + c_b) (theta_a - theta_b) (x_ab . grad_a W_ab)/|x_ab|^2, in W/kg, with the
/// volumes V = m/rho, the integral theta of the conductivity over the temperature, and c = 3/(1 + 2 M), M_a = sum_b V_b
/// |grad_a W_ab| |x_ab|/dim, limited so that the exchange is at most 1.3 times as stiff as on a lattice. One particle
/// gains what the other loses: heat is conserved to rounding. Convection needs no term: particles carry their heat
/// along.
///
/// In a phase, beside HeatCapacity or Melting. A free surface or a wall without HeatTransfer is insulated: c, 1 inside,
/// makes up for the missing neighbours there. Without it heat flows half as well along such a surface. The formula is
/// chosen so that the flow along a strip of ten particles is right to 0.4 % (tests/terms/test_heat.cpp).
///
/// With theta, the conductivity may change with the temperature and jump where the phase freezes (docs/validation.md,
/// stefan). The harmonic mean of two conductivities is wrong for a front between two particles.
///
/// A total-Lagrangian solid takes it with `Reference`: the neighbours of the stress-free solid, which are found once.
/// Heat is then conducted as if the solid were not deformed.
///
/// Not for frictional heating: the energy that viscosity dissipates is not added to the heat. Not with kernels whose
/// slope does not vanish at the centre (Spiky).
///
/// Source: Cleary and Monaghan (1999), Eq. (28), of an enthalpy; theta, Kirchhoff (1894); c, own.
/// @tparam Neighbours Current or Reference
template <class Kernel = WendlandC2, class Neighbours = Current>
struct HeatConduction {
    static constexpr bool within_phases = true;
    using Prepared = PreparedConduction;
    struct Moment {
        using neighbourhood = Neighbours;
        using reads = Fields<volume>;
        using adds = Fields<conduction_moment, conduction_stiffness>;

        IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
            return detail::conduction_sums<Kernel>(b, ab);
        }
    };
    struct Correct {
        using reads = Fields<conduction_moment, conduction_stiffness>;
        using sets = Fields<conduction_correction>;
        static constexpr bool in_packs = true;
        Prepared prepared{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            return 1 /
                   max((1.0 / 3) + (2.0 / 3) * a[conduction_moment], prepared.per_stiffness * a[conduction_stiffness]);
        }
    };
    struct Conduct {
        using neighbourhood = Neighbours;
        using reads = Fields<mass, volume, conduction_potential, conduction_correction>;
        using adds = Fields<enthalpy_rate>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            return (detail::sum_of_corrections(a, b) * a[volume] * b[volume] / a[mass] * ab.gradient(Kernel{})) *
                   (a[conduction_potential] - b[conduction_potential]);
        }
    };
    using parts = Parts<Volume, Moment, Correct, Conduct>;

    /// Computed from the scene's lattice.
    template <int dim>
    static Prepared prepare(const auto&, const Lattice<dim>& lattice) {
        const auto stiffness = [](const auto& ab) { return -sq(ab.support_radius) * ab.gradient(Kernel{}); };
        const Pair<dim, double> itself({}, 0, SupportRadius(lattice.support_radius), {});
        const double all = lattice.volume() * (lattice.sum(stiffness) + stiffness(itself));
        return {.per_stiffness = all > 0 ? 1 / (1.3 * all) : 0};
    }

    static constexpr const char* limit_name = "heat conduction";
    /// H^2 rho c/(1.3 S k), s, with S = 14 for WendlandC2: 0.055 H^2 over the diffusivity k/(rho c).
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        return detail::conduction_limit<Kernel>(material, detail::greatest_conductivity(material, 0), in);
    }
};

/// dh_a/dt = 1/m_a sum_b V_a V_b (c_a + c_b) 2 k_a k_b/(k_a + k_b) (T_a - T_b) (x_ab . grad_a W_ab)/|x_ab|^2, in W/kg,
/// between particles of two phases, with the volumes V = m/rho, the corrections c of HeatConduction, in which the other
/// phase counts, and the harmonic mean of the conductivities k, which keeps the flux continuous where they jump. One
/// phase gains what the other loses.
///
/// In the coupling of two phases with HeatConduction, and in that of one and a wall with a SurfaceTemperature, which
/// takes the other's c. A coupling without it is insulated.
///
/// Not for surfaces with a contact resistance: they exchange heat as if they were one body.
///
/// Source: Cleary and Monaghan (1999), Eq. (28), of an enthalpy; c, own.
template <class Kernel = WendlandC2>
struct HeatTransfer {
    struct Moment {
        using reads = Fields<volume>;
        using adds = Fields<conduction_moment, conduction_stiffness>;

        IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
            return detail::conduction_sums<Kernel>(b, ab);
        }
    };
    struct Conduct {
        using reads = Fields<mass, volume, temperature, conductivity, conduction_correction>;
        using adds = Fields<enthalpy_rate>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const auto mean = a[conductivity] * b[conductivity] / max(a[conductivity] + b[conductivity], 1e-30);
            return (2 * mean * detail::sum_of_corrections(a, b) * a[volume] * b[volume] / a[mass] *
                    ab.gradient(Kernel{})) *
                   (a[temperature] - b[temperature]);
        }
    };
    using parts = Parts<Volume, Moment, Conduct>;

    static constexpr const char* limit_name = "heat transfer";
    /// The limit of HeatConduction of either phase that holds heat, s, with the mean conductivity of the pair.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in) {
        const double own = detail::greatest_conductivity(material_a, 0),
                     other = detail::greatest_conductivity(material_b, own),
                     first = detail::greatest_conductivity(material_a, other),
                     mean = 2 * first * other / std::max(first + other, 1e-300);
        return std::min(detail::conduction_limit<Kernel>(material_a, mean, in),
                        detail::conduction_limit<Kernel>(material_b, mean, in));
    }
};

} // namespace imbibe
