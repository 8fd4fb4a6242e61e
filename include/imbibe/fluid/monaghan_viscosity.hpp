// Monaghan's artificial viscosity: damps approaching pairs, in fluids and in solids.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/term.hpp>
#include <imbibe/fluid/pairwise_laplacian.hpp>
#include <imbibe/state/wave_speed.hpp>

#include <limits>

namespace imbibe {

/// Coefficients of MonaghanViscosity.
struct MonaghanViscosityParameters {
    /// Strength of the linear part (damping of sound). The usual value is 1 in solids, 0.01 to 0.1 in free flow.
    double alpha = 1;
    /// Strength of the quadratic part, which keeps particles in strong shocks from passing through each other, and
    /// hardly acts otherwise. The paper has none; the usual value for shocks is 2 alpha. In free-surface impacts, 1
    /// beside a small alpha keeps particles apart at up to 0.3 sound speeds (docs/stability.md).
    double beta = 0;

    /// Throws Error for a number out of range. @param where the phase or coupling in the message
    void check(std::string_view where) const {
        require_not_negative(alpha, where, "MonaghanViscosityParameters::alpha", "");
        require_not_negative(beta, where, "MonaghanViscosityParameters::beta", "");
    }
};

/// dv_a/dt = - sum_b m_b Pi_ab grad_a W_ab, in m/s^2, with
///
///     Pi_ab = (-alpha c_ab mu_ab + beta mu_ab^2) / rho_ab   where mu_ab < 0, else 0,
///     mu_ab = H (v_a - v_b) . (x_a - x_b) / (|x_a - x_b|^2 + (0.1 H)^2);
///
/// c_ab and rho_ab are the means of the sound speeds of the materials and of the densities of the two particles.
///
/// Sign: Pi_ab >= 0, with a minus before the sum, as in most of the literature: an added pressure between particles
/// that approach. The paper writes Pi = +alpha c mu/rho with a plus before the sum, which is the same force; mixing
/// the two conventions would feed the motion.
/// Length: H is the support radius, as in the paper. Papers that write h for half of it mean, with the same alpha,
/// half of this viscosity.
///
/// Damps the noise of an elastic solid and the sound in a weakly compressible fluid; keeps particles from running
/// through each other. Conserves linear and angular momentum (the force is central).
///
/// Not a physical viscosity: in shear it acts as a kinematic viscosity of about alpha c H/20 (3D), far above that
/// of water for alpha = 1. For real viscosity use LaminarViscosity.
///
/// Source: Monaghan (1992); the paper, Eqs. (15) and (16), where alpha is not given.
template <class Kernel>
struct MonaghanViscosity {
    using Parameters = MonaghanViscosityParameters;
    using reads = Fields<mass, density, velocity>;
    using adds = Fields<acceleration>;
    Parameters parameters{};

    IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        // mu_ab = H approach/away if negative. H and the halves of the means are multiplied into the coefficients,
        // which are constant over pairs, and everything has one denominator: two quotients take longer than all the
        // rest. Its sum is expanded so that one more operand can come from memory.
        const auto H = ab.support_radius;
        const auto approach = negative_part(dot(a[velocity] - b[velocity], ab.offset));
        const auto away = squared_norm(ab.offset) + sq(0.1 * H);
        const double c = detail::mean_sound_speed(a.material, b.material);
        const auto Pi = approach *
                        (((2 * parameters.beta) * sq(H)) * approach - ((2 * parameters.alpha * c) * H) * away) /
                        (away * (away * a[density] + away * b[density]));
        return along(ab, -((b[mass] * ab.gradient(Kernel{})) * Pi));
    }

    static constexpr const char* limit_name = "artificial viscosity";
    /// 2 H/(f S (alpha c + 2 beta v)), s, with twice the greatest speed for v, at which two particles may meet, S = H^2
    /// times the integral of |grad W| r/(r^2 + (0.1 H)^2), and f = 0.42 in 2D and 0.31 in 3D: 0.41 and 0.51 H/(alpha c)
    /// with WendlandC2. On square and cubic lattices of 1.25 to 4 spacings a support no wave is damped faster than at
    /// the rate f S alpha c/H with any of the library's kernels (half of the neighbours approach at a time), and an
    /// explicit step is stable below 2 over that rate.
    static double time_step_limit(const auto& material, const TimeStepInput& in, const Parameters& parameters) {
        TimeStepInput towards_each_other = in;
        towards_each_other.other_max_speed = in.max_speed;
        return time_step_limit(material, material, towards_each_other, parameters);
    }
    /// The same between two phases.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in,
                                  const Parameters& parameters) {
        const double c = detail::mean_sound_speed(material_a, material_b);
        const double rate = parameters.alpha * c + 2 * parameters.beta * (in.max_speed + in.other_max_speed);
        constexpr double in_2d = 0.42 * detail::pairwise_laplacian_strength<Kernel, 2>(0.1),
                         in_3d = 0.31 * detail::pairwise_laplacian_strength<Kernel, 3>(0.1);
        const double strength = in.dimension == 2 ? in_2d : in_3d;
        return rate > 0 ? 2 * in.support_radius / (strength * rate) : std::numeric_limits<double>::infinity();
    }
};

} // namespace imbibe
