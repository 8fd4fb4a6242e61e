// Hourglass control: resists motions of a total-Lagrangian solid that its deformation gradient does not contain.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/solid/displacement.hpp>

#include <cmath>
#include <limits>

namespace imbibe {

/// Coefficients of HourglassControl.
struct HourglassControlParameters {
    /// Stiffness of the control relative to Young's modulus. 0.1 is plenty for most; more stiffens bending.
    double alpha = 0.1;

    /// Throws Error for a number out of range. @param where the phase or coupling in the message
    void check(std::string_view where) const {
        require_not_negative(alpha, where, "HourglassControlParameters::alpha", "");
    }
};

/// dv_a/dt = - alpha E/m_a sum_b V_a V_b W_ab/|X_ab|^2 (e_ab . n_ab) n_ab, in m/s^2, with
///
///     e_ab = x_ab - (F_a + F_b)/2 X_ab,   n_ab = x_ab/|x_ab|,
///
/// Young's modulus E and the kernel W of the stress-free solid. e_ab is the deviation of the pair from the mean
/// deformation gradient of the two: zero for every affine motion. The force of the pair is along its present line of
/// centres, equal and opposite, so linear and angular momentum are conserved.
///
/// For every total-Lagrangian solid that bends, is thin or suffers impacts.
///
/// Not a damping: it stores energy. Its error is second order in the spacing, but it adds stiffness to a coarse solid:
/// not where a plate of few layers must bend right to the last percent. Not beside PairwiseShearForce, which has no
/// such motions.
///
/// Source: Ganzenmueller (2015), with alpha = 0.1.
template <class Kernel = WendlandC2>
struct HourglassControl {
    static constexpr bool of_solids = true;
    using Parameters = HourglassControlParameters;

    struct Push {
        using neighbourhood = Reference;
        using reads = Fields<mass, displacement, deformation_gradient>;
        using adds = Fields<acceleration>;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            using V = std::remove_cvref_t<decltype(ab.offset)>;
            using T = typename V::Scalar;
            const V now = ab.offset + (a[displacement] - b[displacement]);
            const V error = now - T(0.5) * ((a[deformation_gradient] + b[deformation_gradient]) * ab.offset);
            const double E = 0.5 * (a.material.young_modulus() + b.material.young_modulus());
            const double per_mass = parameters.alpha * E / (a.material.density * b.material.density);
            const T least = sq(T(1e-6) * ab.support_radius); // of the particle itself and its own position
            const T stretch = dot(error, now) / max(squared_norm(now), least);
            return (-per_mass * b[mass] * ab.value(Kernel{}) * ab.inverse_squared_distance() * stretch) * now;
        }
    };
    using parts = Parts<Displacement, Push>;

    static constexpr const char* limit_name = "hourglass stiffness";
    /// 2 spacing/(c sqrt(0.8 alpha)), s, with c = sqrt(E/rho_0): 2 over the highest frequency. On square and cubic
    /// lattices of 1.5 to 4 spacings a support no wave is faster than 0.76 c sqrt(alpha)/spacing in 2D and
    /// 0.63 c sqrt(alpha)/spacing in 3D, with WendlandC2: wider supports have more neighbours, which count for less.
    static double time_step_limit(const auto& material, const TimeStepInput& in, const Parameters& parameters) {
        const double stiffness = 0.8 * parameters.alpha * material.young_modulus() / material.density;
        return stiffness > 0 ? 2 * in.spacing / std::sqrt(stiffness) : std::numeric_limits<double>::infinity();
    }
};

} // namespace imbibe
