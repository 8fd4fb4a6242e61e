// The pressure of a liquid with Cohesion: what its equation of state and the pull of its particles leave together.
#pragma once

#include <imbibe/core/method.hpp>
#include <imbibe/core/term.hpp>
#include <imbibe/interface/cohesion.hpp>

#include <type_traits>

namespace imbibe {

/// The pressure of a liquid, Pa: see LiquidPressure.
struct LiquidPressureField : Field<Rank::scalar> {
    static constexpr std::string_view name = "liquid_pressure", unit = "Pa";
    static constexpr bool shown = true;
};
inline constexpr LiquidPressureField liquid_pressure{};

namespace detail {
// The share of a pair in the pressure of a: x_ab.f_ab/(2 dim V_a), with the force f_ab/(V_a V_b) along x_ab.
IMBIBE_INLINE constexpr auto virial(const auto& force, const auto& a, const auto& b, const auto& ab) {
    constexpr int dim = std::remove_cvref_t<decltype(a)>::dimension;
    return (0.5 / dim) * force * squared_norm(ab.offset) * b[mass] *
           (a[density] / (a.material.density * b.material.density));
}
} // namespace detail

/// The part of SymmetricPressure<WendlandC6> in LiquidPressure, Pa. Not without CohesionVirial, whose part is as large.
///
/// Source: see LiquidPressure.
struct PressureVirial {
    struct Sum {
        using reads = Fields<mass, density, pressure_over_density2>;
        using adds = Fields<liquid_pressure>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            return detail::virial(-sq(a.material.density) * (a[pressure_over_density2] + b[pressure_over_density2]) *
                                      ab.gradient(WendlandC6{}),
                                  a, b, ab);
        }
    };
    using parts = Parts<Sum>;
    static constexpr bool within_phases = true;
};

/// The part of Cohesion in LiquidPressure, Pa. Not without PressureVirial.
///
/// Source: see LiquidPressure.
struct CohesionVirial {
    using Parameters = CohesionParameters;
    using Prepared = PreparedCohesion;
    static constexpr bool within_phases = true;
    struct Sum {
        using reads = Fields<mass, density>;
        using adds = Fields<liquid_pressure>;
        Prepared prepared{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            return detail::virial(prepared.strength * ab.gradient(WendlandC6{}), a, b, ab);
        }
    };
    using parts = Parts<Sum>;

    /// Throws Error without Cohesion. @param owner the fluid, @param where its name in the message
    static void check(const auto& owner, std::string_view where) { detail::check_cohesive(owner, where); }
    /// That of Cohesion, m.
    static double support_radius(const auto& material) { return Cohesion::support_radius(material); }
    /// kappa.
    template <int dim>
    static Prepared prepare(const auto& material, const Lattice<dim>&, const Parameters& parameters) {
        return detail::prepared_cohesion<dim>(material, parameters);
    }
};

/// p_a = 1/(2 dim V_a) sum_b x_ab.f_ab, in Pa, with the forces f_ab of SymmetricPressure and Cohesion: the field
/// liquid_pressure, the pressure in a liquid over that outside, sigma/R in a drop. (`pressure` also contains p_i, 5.2
/// sigma/spacing.) It changes no motion; it costs as much as the two forces.
///
/// Not within 6.25 spacings of a surface, a wall or a solid: there it is one part of a stress with a direction. Take
/// its mean over many particles.
///
/// Source: Clausius (1870), the virial.
struct LiquidPressure : Method<PressureVirial, CohesionVirial> {};

} // namespace imbibe
