// The state of a fluid that may be in the pores of a skeleton.
#pragma once

#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/mixture/pore_space.hpp>
#include <imbibe/state/linear_state.hpp>

#include <string_view>
#include <type_traits>

namespace imbibe {

/// The pressure of the fluid itself, Pa. Its `pressure` is n times as much in the pores of a skeleton, of porosity n.
struct PorePressureField : Field<Rank::scalar> {
    static constexpr std::string_view name = "pore_pressure", unit = "Pa";
    static constexpr bool shown = true;
};
inline constexpr PorePressureField pore_pressure{};

namespace detail {
// A particle of a fluid in pores as its equation of state sees it: with the density of the fluid itself.
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
} // namespace detail

/// p = `State`(rho/n), the pore pressure, and n p, the `pressure`, in Pa, with the porosity n. The density rho of a
/// particle is the mass in all of the space, n times that of the fluid itself, and its pressure is the force on all of an
/// area, n times that of the fluid: with these two the fluid in the pores has the equations of a fluid in free space, and
/// the same terms, and the coupling with the skeleton adds p grad n (PorePressure). Where there is no skeleton n is 1.
///
/// `fill_pores` gives particles that begin inside a skeleton their mass and density.
///
/// Not beside DensityFloor or DensityDiffusion, which take densities for those of the fluid itself: the first is part of
/// this, by InPoresParameters::tension, and for the second there is PoreDensityDiffusion.
///
/// Source: Biot (1941), with incompressible grains.
template <class State = LinearState>
struct InPores {
    struct Set {
        using reads = detail::Concat<typename State::reads, Fields<porosity>>;
        using sets = Fields<pore_pressure, pressure>;
        static constexpr bool in_packs = true;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            using A = std::remove_cvref_t<decltype(a)>;
            const auto p = State{}(detail::InsidePores<A>{a, a.material});
            return values(p, a[porosity] * p);
        }
    };
    using parts = Parts<Set>;

    /// The density of the fluid itself at a pressure p, Pa, kg/m^3.
    static double density_at(const auto& material, double p) { return State::density_at(material, p); }

    /// m c^2 (rho/(n rho_0) - 1)^2/2 of a particle, J.
    struct Energy {
        using reads = Fields<mass, density, porosity>;
        using reduces = Sum<StoredEnergy>;

        double operator()(const auto& a) const {
            const double n = a[porosity] > 0 ? a[porosity] : 1; // not computed yet
            return 0.5 * a[mass] * sq(a.material.sound_speed * (a[density] / (n * a.material.density) - 1));
        }
    };
    using reductions = Parts<Energy>;

    static constexpr const char* limit_name = State::limit_name;
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        return State::time_step_limit(material, in);
    }
};

/// 2 delta h c sum_b V_b (n_a + n_b)/2 (r_b - r_a - s_ab rho_0/c^2 g.(x_b - x_a)) (x_b - x_a).grad_a W_ab/|x_ab|^2,
/// added to drho_a/dt, in kg/m^3/s: DensityDiffusion of the density r = rho/n of the fluid itself, with the porosity n.
///
/// In place of DensityDiffusion in a fluid with InPores, whose pressure is a checkerboard without it.
///
/// Not stronger than it must be: 0.02 is enough in a skeleton, and what it smooths, the pressure, is what drives the
/// flow there; delta h c should be small beside the diffusivity k (K + 4 G/3)/eta of the pressure, times the fluid's
/// bulk modulus over the skeleton's.
///
/// Source: as DensityDiffusion.
template <class Kernel = WendlandC2>
struct PoreDensityDiffusion {
    using effect = effects::density_diffusion;
    static constexpr bool within_phases = true;
    using Parameters = DensityDiffusionParameters;
    struct Smooth {
        using reads = Fields<density, porosity, volume, supported_share>;
        using adds = Fields<density_rate>;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const double c = a.material.sound_speed;
            const auto share = 0.5 * a.material.density / sq(c) * (a[supported_share] + b[supported_share]);
            const auto excess =
                a[density] / a[porosity] - b[density] / b[porosity] - share * dot(ab.gravity(), ab.offset);
            return (0.5 * parameters.delta * c) * (a[porosity] + b[porosity]) * ab.support_radius * b[volume] * excess *
                   ab.gradient(Kernel{});
        }
    };
    using parts = Parts<Volume, Smooth>;

    static constexpr const char* limit_name = DensityDiffusion<Kernel>::limit_name;
    static double time_step_limit(const auto& material, const TimeStepInput& in, const Parameters& parameters) {
        return DensityDiffusion<Kernel>::time_step_limit(material, in, parameters);
    }
};

} // namespace imbibe
