// Internal damping of a total-Lagrangian solid.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/fluid/pairwise_laplacian.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/solid/displacement.hpp>

namespace imbibe {

/// Coefficients of TotalLagrangianViscosity.
struct TotalLagrangianViscosityParameters {
    /// Strength. 0.02 damps the ringing of single particles and lets a plate swing; 1 is for hard impact.
    double alpha = 0.02;

    /// Throws Error for a number out of range. @param where the phase or coupling in the message
    void check(std::string_view where) const {
        require_not_negative(alpha, where, "TotalLagrangianViscosityParameters::alpha", "");
    }
};

/// dv_a/dt = alpha h c/rho_0 sum_b m_b F_ab (v_ab . x_ab)/|x_ab|^2 x_ab, in m/s^2, with grad_a W_ab = F_ab X_ab of the
/// stress-free solid (F_ab < 0), the present offset x_ab, h = H/2 and the bulk speed of sound c.
///
/// Damps stretching and shortening alike, in proportion to their rate (a Kelvin-Voigt solid with the shear viscosity
/// alpha rho_0 c H/20 in 3D, alpha rho_0 c H/16 in 2D), and leaves rotations alone. The force of the pair is along its
/// present line of centres, equal and opposite: linear and angular momentum are conserved.
///
/// Not a model of a real material's damping: it decreases with the spacing.
///
/// Source: the linear part of Monaghan (1992) on stress-free neighbours, for receding pairs too.
template <class Kernel = WendlandC2>
struct TotalLagrangianViscosity {
    using Parameters = TotalLagrangianViscosityParameters;

    struct Push {
        using neighbourhood = Reference;
        using reads = Fields<mass, displacement, velocity>;
        using adds = Fields<acceleration>;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            using V = std::remove_cvref_t<decltype(ab.offset)>;
            using T = typename V::Scalar;
            const V now = ab.offset + (a[displacement] - b[displacement]);
            const T least = sq(T(1e-6) * ab.support_radius); // of the particle itself and its own position
            const T rate = dot(a[velocity] - b[velocity], now) / max(squared_norm(now), least);
            const double scale = parameters.alpha * (a.material.sound_speed + b.material.sound_speed) /
                                 (2 * (a.material.density + b.material.density)); // alpha c/(2 rho_0)
            return (scale * b[mass] * ab.support_radius * ab.gradient(Kernel{}) * rate) * now;
        }
    };
    using parts = Parts<Displacement, Push>;

    static constexpr const char* limit_name = "solid viscosity";
    /// 2.8 dim H/(S alpha c) in 2D and 2.4 dim H/(S alpha c) in 3D, s, with S = 14 for WendlandC2: 2 over the fastest
    /// rate of decay.
    static double time_step_limit(const auto& material, const TimeStepInput& in, const Parameters& parameters) {
        const double in_order = 0.8; // share of what disorder would need: a solid keeps its initial neighbours
        return detail::central_diffusion_limit<Kernel>(
            in_order * parameters.alpha * 0.25 * in.support_radius * material.sound_speed / in.dimension, in);
    }
};

} // namespace imbibe
