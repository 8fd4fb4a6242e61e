// How stiff the Laplacian of particle pairs is: what diffusion and viscosity written with first kernel derivatives
// have in common, and the time step they allow.
#pragma once

#include <imbibe/core/term.hpp>

#include <limits>

namespace imbibe::detail {

// H^2 times the integral of |grad W|/r over the support, by the midpoint rule. 14 for WendlandC2 in 2D and in 3D.
template <class Kernel, int dim>
constexpr double pairwise_laplacian_strength() {
    constexpr int n = 256;
    double integral = 0;
    for (int k = 0; k < n; ++k) {
        const double q = (k + 0.5) / n;
        integral -= power<dim - 2>(q) * Kernel::derivative(q) / n;
    }
    constexpr double circle = 2 * 3.14159265358979323846, sphere = 2 * circle;
    return (dim == 2 ? circle : sphere) * Kernel::template normalisation<dim>() * integral;
}

// The largest stable explicit step, s, of du_a/dt = -2 D sum_b V_b (u_a - u_b) |grad W_ab|/r_ab, which approximates
// D times the Laplacian of u: the sum of the weights bounds the fastest decay rate by 4 D S/H^2, and a step must stay
// below 2 over the rate.
template <class Kernel>
double pairwise_diffusion_limit(double diffusivity, const TimeStepInput& in) {
    if (!(diffusivity > 0))
        return std::numeric_limits<double>::infinity();
    const double strength =
        in.dimension == 2 ? pairwise_laplacian_strength<Kernel, 2>() : pairwise_laplacian_strength<Kernel, 3>();
    return in.support_radius * in.support_radius / (2 * strength * diffusivity);
}

} // namespace imbibe::detail
