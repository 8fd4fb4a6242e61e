// The state of a fluid that may flow in the pores of a skeleton.
#pragma once

#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/density_floor.hpp>
#include <imbibe/mixture/pore_space.hpp>
#include <imbibe/state/linear_state.hpp>

#include <algorithm>
#include <string_view>
#include <type_traits>

namespace imbibe {

/// The pressure of the fluid itself, Pa; its `pressure` is the force per total area (InPores).
struct PorePressureField : Field<Rank::scalar> {
    static constexpr std::string_view name = "pore_pressure", unit = "Pa";
    static constexpr bool shown = true;
};
inline constexpr PorePressureField pore_pressure{};

/// The wetting kappa of the skeleton around a fluid's particle, Pa; see InPores.
struct Wetting : Field<Rank::scalar> {
    static constexpr std::string_view name = "wetting", unit = "Pa";
};
inline constexpr Wetting wetting{};

namespace detail {
// A particle of a fluid in pores, for its equation of state: with the density of the fluid itself.
template <class A>
struct InsidePores {
    using Material = typename A::Material;
    using Scalar = typename A::Scalar;
    static constexpr int dimension = A::dimension;
    const A& a;
    const Material& material;

    template <class F>
    IMBIBE_INLINE constexpr auto operator[](F field) const {
        if constexpr (std::is_same_v<F, Density>)
            return a[density] / a[porosity];
        else
            return a[field];
    }
};

// -dn_a/dA_a, and dn_a/dB_a over that.
IMBIBE_INLINE constexpr auto per_solid_sum(const auto& fluid) {
    return 1 / max(fluid[skeleton_sum], least_inner_sum);
}
IMBIBE_INLINE constexpr auto inner_solid_share(const auto& fluid) {
    using T = std::remove_cvref_t<decltype(fluid[skeleton_sum])>;
    return select(fluid[skeleton_sum] > T(least_inner_sum), 1 - fluid[porosity], T(0));
}
} // namespace detail

/// The state of a fluid that may flow in the pores of a skeleton:
///
///     n_a = 1 - A_a/max(B_a, 0.95),    p = State(rho/n),    P = n p + (1 - n) kappa, in Pa,
///
/// with the sums A and B of PoreSpace. The porosity n is the share of space that the fluid fills. In a uniform skeleton
/// it is uniform for any arrangement of particles; at the surface it rises to 1 over a support radius. The density rho
/// is the mass per total volume, n times that of the fluid itself, and p is the fluid's `pore_pressure`. P is its
/// `pressure`, the force per total area. With these two the fluid in the pores has the equations of a fluid in free
/// space, and the same terms; PorePressure adds the action of the skeleton.
///
/// kappa = p_c n_0/(1 - n_0) is the wetting of a skeleton with the porosity n_0: the fluid gains the energy kappa (1 -
/// n)/n per volume of it in the pores, which gives the suction p_c in the stress-free skeleton. At a free surface P is
/// 0, and p is less by the suction: a front in dry pores is drawn forward. In the fluid behind it p is negative but P
/// is not, so its particles do not clump.
///
/// `fill_pores` gives particles that start inside a skeleton their mass and density.
///
/// Not beside DensityFloor or DensityDiffusion, which use the density of the fluid itself: take PoreDensityFloor and
/// PoreDensityDiffusion. Not for pores with a distribution of suctions.
///
/// Source: Biot (1941), with incompressible grains; the quotient, Shepard (1968); the energy of wetting as a function
/// of the porosity, own.
template <class State = LinearState>
struct InPores {
    struct Share {
        using reads = Fields<solid_sum, skeleton_sum, wetting_sum>;
        using sets = Fields<porosity, wetting>;
        static constexpr bool in_packs = true;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            return values(1 - a[solid_sum] * detail::per_solid_sum(a), a[wetting_sum] / max(a[solid_sum], 1e-30));
        }
    };
    struct Press {
        using reads = detail::Concat<typename State::reads, Fields<porosity, wetting>>;
        using sets = Fields<pore_pressure, pressure>;
        static constexpr bool in_packs = true;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            using A = std::remove_cvref_t<decltype(a)>;
            const auto p = State{}(detail::InsidePores<A>{a, a.material});
            return values(p, a[porosity] * p + (1 - a[porosity]) * a[wetting]);
        }
    };
    using parts = Parts<Share, Press>;

    /// The density of the fluid itself at a pressure p, Pa, kg/m^3.
    static double density_at(const auto& material, double p) { return State::density_at(material, p); }

    /// m (c^2 (r/rho_0 - 1)^2/2 - p_s/r) of a particle, J, with the density r = rho/n of the fluid itself.
    struct Energy {
        using reads = Fields<mass, density, porosity, wetting>;
        using reduces = Sum<StoredEnergy>;

        double operator()(const auto& a) const {
            const double n = a[porosity] > 0 ? a[porosity] : 1; // before the first evaluation
            return a[mass] * (0.5 * sq(a.material.sound_speed * (a[density] / (n * a.material.density) - 1)) -
                              a[wetting] * (1 - n) / a[density]);
        }
    };
    using reductions = Parts<Energy>;

    static constexpr const char* limit_name = State::limit_name;
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        return State::time_step_limit(material, in);
    }
};

/// Coefficients of PoreDensityDiffusion.
struct PoreDensityDiffusionParameters {
    /// Strength outside the skeleton, without unit, as DensityDiffusionParameters::delta.
    double delta = 0.1;
    /// Strength inside it. It smooths the pressure, which drives the flow there.
    double delta_in_pores = 0.01;

    /// Throws Error for a number out of range. @param where the phase in the message
    void check(std::string_view where) const {
        require_not_negative(delta, where, "PoreDensityDiffusionParameters::delta", "");
        require_not_negative(delta_in_pores, where, "PoreDensityDiffusionParameters::delta_in_pores", "");
    }
};

/// drho_a/dt += h c sum_b V_b (delta_a n_a + delta_b n_b) (r_b - r_a - s_ab rho_0/c^2 g.(x_b - x_a)) (x_b - x_a).grad_a
/// W_ab/|x_ab|^2, in kg/m^3/s: DensityDiffusion of the density r = rho/n of the fluid itself. From outside to inside
/// the skeleton delta varies with the sum B of PoreSpace.
///
/// Use it in place of DensityDiffusion in a fluid with InPores, whose pressure is a checkerboard without it.
///
/// Not stronger than necessary: inside, delta h c should be small compared with the diffusivity k (K + 4 G/3)/eta of
/// the pressure, times the fluid's bulk modulus over the skeleton's.
///
/// Source: as DensityDiffusion.
template <class Kernel = WendlandC2>
struct PoreDensityDiffusion {
    using effect = effects::density_diffusion;
    static constexpr bool within_phases = true;
    using Parameters = PoreDensityDiffusionParameters;
    struct Smooth {
        using reads = Fields<density, porosity, skeleton_sum, volume, supported_share>;
        using adds = Fields<density_rate>;
        Parameters parameters{};

        /// delta n of a particle.
        IMBIBE_INLINE constexpr auto strength(const auto& a) const {
            const double change = parameters.delta_in_pores - parameters.delta;
            return a[porosity] * (parameters.delta + change * min(a[skeleton_sum], 1.0));
        }
        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const double c = a.material.sound_speed;
            const auto share = 0.5 * a.material.density / sq(c) * (a[supported_share] + b[supported_share]);
            const auto excess =
                a[density] / a[porosity] - b[density] / b[porosity] - share * dot(ab.gravity(), ab.offset);
            return (0.5 * c) * (strength(a) + strength(b)) * ab.support_radius * b[volume] * excess *
                   ab.gradient(Kernel{});
        }
    };
    using parts = Parts<Volume, Smooth>;

    static constexpr const char* limit_name = DensityDiffusion<Kernel>::limit_name;
    static double time_step_limit(const auto& material, const TimeStepInput& in, const Parameters& parameters) {
        return DensityDiffusion<Kernel>::time_step_limit(
            material, in, {.delta = std::max(parameters.delta, parameters.delta_in_pores)});
    }
};

/// drho_a/dt += rate c/spacing max(n (1 - slack) rho_0 - (1 - n) kappa/c^2 - rho_a, 0), in kg/m^3/s: DensityFloor for a
/// fluid with InPores, whose `pressure` then does not fall far below 0. In pores the fluid bears the suction; under
/// more tension the pores drain.
///
/// Use it in place of DensityFloor, with the same coefficients.
///
/// Not for a fluid that cannot open voids, such as one that fills a closed box.
///
/// Source: that of DensityFloor.
struct PoreDensityFloor {
    using Parameters = DensityFloorParameters;
    using reads = Fields<density, porosity, wetting>;
    using adds = Fields<density_rate>;
    Parameters parameters{};

    IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
        const auto& fluid = a.material;
        const double per_time = parameters.rate * fluid.sound_speed / max(fluid.spacing, 1e-30);
        return per_time * positive_part(a[porosity] * ((1 - parameters.slack) * fluid.density) -
                                        (1 - a[porosity]) * a[wetting] * (1 / sq(fluid.sound_speed)) - a[density]);
    }

    static constexpr const char* limit_name = DensityFloor::limit_name;
    static double time_step_limit(const auto& material, const TimeStepInput& in, const Parameters& parameters) {
        return DensityFloor::time_step_limit(material, in, parameters);
    }
};

} // namespace imbibe
