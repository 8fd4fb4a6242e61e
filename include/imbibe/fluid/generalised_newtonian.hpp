// Liquids whose viscosity depends on how fast they are sheared: blood, paste, ink.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/fluid/pairwise_laplacian.hpp>
#include <imbibe/fluid/volume.hpp>
#include <imbibe/kernels/wendland.hpp>

#include <cmath>

namespace imbibe {

/// sum_b V_b sym((v_b - v_a) (x) grad_a W_ab), 1/s: the rate of strain that sets the viscosity.
struct StrainRate : Field<Rank::symmetric_tensor> {
    static constexpr std::string_view name = "strain_rate", unit = "1/s";
};
inline constexpr StrainRate strain_rate{};

/// The viscosity at the present rate of shear, Pa s.
struct ApparentViscosity : Field<Rank::scalar> {
    static constexpr std::string_view name = "apparent_viscosity", unit = "Pa s";
    static constexpr bool shown = true;
};
inline constexpr ApparentViscosity apparent_viscosity{};

/// Coefficients of Carreau.
struct CarreauParameters {
    double at_rest = 0;    ///< eta_0, Pa s: the viscosity without shear
    double fast = 0;       ///< eta_inf, Pa s: the limit of the viscosity at high shear rates
    double time = 0;       ///< lambda, s: rates above 1/lambda thin the liquid
    double exponent = 1;   ///< n: the viscosity falls as the rate to the power n - 1
    double transition = 2; ///< a: how sharp the transition is (Yasuda); 2 is Carreau's

    /// Throws Error for a number out of range. @param where the phase in the message
    void check(std::string_view where) const {
        require(std::isfinite(at_rest) && at_rest > 0, where, ": CarreauParameters::at_rest = ", at_rest,
                " Pa s; it must be a finite number above 0 Pa s");
        require_not_negative(fast, where, "CarreauParameters::fast", "Pa s");
        require_not_negative(time, where, "CarreauParameters::time", "s");
        require(exponent > 0 && exponent <= 2, where, ": CarreauParameters::exponent = ", exponent,
                "; it must be above 0 and at most 2 (below 1 the liquid thins, above it thickens)");
        require(std::isfinite(transition) && transition > 0, where, ": CarreauParameters::transition = ", transition,
                "; it must be finite and above 0, usually 2");
    }
};

/// eta = eta_inf + (eta_0 - eta_inf) (1 + (lambda gamma)^a)^((n - 1)/a), Pa s, of the rate of shear gamma.
///
/// For polymer solutions and blood (in blood eta_0 = 0.056, eta_inf = 0.00345 Pa s, lambda = 3.313 s, n = 0.3568).
///
/// Not for liquids with a yield stress: HerschelBulkley.
///
/// Source: Carreau (1972); with a, Yasuda, Armstrong and Cohen (1981); the numbers of blood, Cho and Kensey (1991).
struct Carreau {
    using Parameters = CarreauParameters;
    /// eta, Pa s, at a rate of shear, 1/s.
    static constexpr auto viscosity(const Parameters& p, const auto& rate) {
        using T = std::remove_cvref_t<decltype(rate)>;
        return T(p.fast) +
               (p.at_rest - p.fast) * pow(T(1) + pow(p.time * rate, p.transition), (p.exponent - 1) / p.transition);
    }
};

/// Coefficients of HerschelBulkley.
struct HerschelBulkleyParameters {
    double consistency = 0;  ///< K, Pa s^n
    double exponent = 1;     ///< n: below 1 it thins, above it thickens; 1: Bingham's liquid
    double yield_stress = 0; ///< tau_0, Pa: below it it hardly flows
    /// m, s: how sharply it yields. At rest the viscosity is tau_0 m, which limits the time step; m gamma >> 1 where
    /// the liquid flows.
    double sharpness = 0;
    /// The rate, 1/s, below which the power-law viscosity is held constant. With n < 1 it would be infinite at 0.
    double least_rate = 1e-3;

    /// Throws Error for a number out of range. @param where the phase in the message
    void check(std::string_view where) const {
        require(std::isfinite(consistency) && consistency > 0, where,
                ": HerschelBulkleyParameters::consistency = ", consistency,
                " Pa s^n; it must be a finite number above 0 Pa s^n");
        require(exponent > 0 && exponent <= 2, where, ": HerschelBulkleyParameters::exponent = ", exponent,
                "; it must be above 0 and at most 2");
        require_not_negative(yield_stress, where, "HerschelBulkleyParameters::yield_stress", "Pa");
        require_not_negative(sharpness, where, "HerschelBulkleyParameters::sharpness", "s");
        require(yield_stress == 0 || sharpness > 0, where,
                ": HerschelBulkleyParameters::sharpness = 0 s with a yield stress of ", yield_stress,
                " Pa; give some 100 over the rate of shear of the flow");
        require(std::isfinite(least_rate) && least_rate > 0, where,
                ": HerschelBulkleyParameters::least_rate = ", least_rate,
                " 1/s; it must be finite and above 0 1/s, some 0.001 of the rate of shear of the flow");
    }
};

/// eta = K gamma^(n - 1) + tau_0 (1 - exp(-m gamma))/gamma, Pa s, of the rate of shear gamma, at least `least_rate` in
/// the power.
///
/// Power-law liquids, Bingham's (n = 1) and pastes with both.
///
/// Not for a paste that must stand still for long: unyielded material creeps, with the viscosity tau_0 m.
///
/// Source: Herschel and Bulkley (1926), regularised by Papanastasiou (1987).
struct HerschelBulkley {
    using Parameters = HerschelBulkleyParameters;
    /// eta, Pa s, at a rate of shear, 1/s.
    static constexpr auto viscosity(const Parameters& p, const auto& rate) {
        using T = std::remove_cvref_t<decltype(rate)>;
        const T x = p.sharpness * rate;
        const T yielding = select(x < T(0.05), T(1) - 0.5 * x + x * x / 6.0, (T(1) - exp(-x)) / max(x, T(1e-30)));
        return p.consistency * pow(max(rate, T(p.least_rate)), p.exponent - 1) +
               p.yield_stress * p.sharpness * yielding;
    }
};

/// The greatest apparent viscosity, Pa s, on which the limit on the step depends. A reduction of
/// GeneralisedNewtonianViscosity.
///
/// Not the viscosity of a phase that follows no such law.
///
/// Source: own.
struct GreatestViscosity {
    using reads = Fields<apparent_viscosity>;
    using reduces = Max<ApparentViscosity>;
    double operator()(const auto& a) const { return static_cast<double>(a[apparent_viscosity]); }
};

/// dv_a/dt = sum_b m_b 4 eta_a eta_b/(eta_a + eta_b)/(rho_a rho_b) (x_ab . grad_a W_ab)/|x_ab|^2 (v_a - v_b), in m/s^2:
/// MorrisViscosity with a viscosity eta_a that follows from the rate of shear gamma_a = sqrt(2 E:E) by the law,
/// E_a = sum_b V_b sym((v_b - v_a) (x) grad_a W_ab). A pair takes the harmonic mean, for its layers are sheared by one
/// stress; with the arithmetic one a paste that yields flows too slowly.
///
/// In the fluid in place of another viscosity; the material's own `viscosity` is ignored. A no-slip wall takes
/// `Into<Wall, NoSlipVelocity<K>>, Into<Liquid, NoSlipStrainRate<K>>, NoSlipApparentViscosity<K>`.
///
/// Not at a free surface if the viscosity there matters: E is summed over the existing neighbours only, and is up to a
/// half too small.
///
/// Source: Morris, Fox and Zhu (1997), Eq. (22); the harmonic mean, Cleary and Monaghan (1999); for such liquids Shao
/// and Lo (2003).
template <class Law, class Kernel = WendlandC2>
struct GeneralisedNewtonianViscosity {
    using effect = effects::viscous_force;
    using viscosity_law = Law;
    using Parameters = typename Law::Parameters;

    struct Sum {
        using reads = Fields<volume, velocity>;
        using adds = Fields<strain_rate>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            return symmetric_part(outer(b[volume] * ab.gradient(Kernel{}) * (b[velocity] - a[velocity]), ab.offset));
        }
    };
    struct Follow {
        using reads = Fields<strain_rate>;
        using sets = Fields<apparent_viscosity>;
        Parameters parameters{};

        constexpr auto operator()(const auto& a) const {
            return Law::viscosity(parameters, sqrt(2 * dot(a[strain_rate], a[strain_rate])));
        }
    };
    struct Push {
        using reads = Fields<mass, density, velocity, apparent_viscosity>;
        using adds = Fields<acceleration>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const auto both = a[apparent_viscosity] + b[apparent_viscosity];
            const auto eta = 4 * a[apparent_viscosity] * b[apparent_viscosity] / max(both, 1e-30);
            return (eta * b[mass] / (a[density] * b[density]) * ab.gradient(Kernel{})) * (a[velocity] - b[velocity]);
        }
    };
    using parts = Parts<Volume, Sum, Follow, Push>;
    static constexpr bool within_phases = true;

    static constexpr const char* limit_name = "viscous diffusion";
    using reductions = Parts<GreatestViscosity>;
    /// The limit of MorrisViscosity with the greatest viscosity of any particle (before the first step, that at rest),
    /// s.
    static double time_step_limit(const auto& material, const TimeStepInput& in, const Parameters& parameters) {
        const double eta = in.greatest > 0 ? in.greatest : Law::viscosity(parameters, 0.0);
        return detail::pairwise_diffusion_limit<Kernel>(eta / material.density, in);
    }
};

} // namespace imbibe
