// How stiff the Laplacian of particle pairs is: what diffusion and viscosity written with first kernel derivatives
// have in common, and the time step they allow.
#pragma once

#include <imbibe/core/term.hpp>

#include <limits>

namespace imbibe::detail {

// H^2 times the integral of |grad W|/r over the support, by the midpoint rule. 14 for WendlandC2 in 2D and in 3D. With a
// softening s, in supports, that of |grad W| r/(r^2 + s^2 H^2).
template <class Kernel, int dim>
constexpr double pairwise_laplacian_strength(double softening = 0) {
    constexpr int n = 256;
    double integral = 0;
    for (int k = 0; k < n; ++k) {
        const double q = (k + 0.5) / n;
        integral -= power<dim>(q) / (sq(q) + sq(softening)) * Kernel::derivative(q) / n;
    }
    constexpr double circle = 2 * 3.14159265358979323846, sphere = 2 * circle;
    return (dim == 2 ? circle : sphere) * Kernel::template normalisation<dim>() * integral;
}

// The largest stable explicit step, s, of du_a/dt = -2 D sum_b V_b (u_a - u_b) |grad W_ab|/r_ab, which approximates
// D times the Laplacian of u: 2 over the fastest rate of decay, for which 2.6 D S/H^2 is taken.
//
// A kernel that has no negative Fourier coefficient in one dimension (Wendland's, the splines) has none of |grad W|/r in
// two and three (Wendland 2005, Scattered Data Approximation, chapter 9). The matrix of the weights with the particles
// themselves is then positive, and no wave decays faster than at the rate 2 D sum_b V_b |grad W_ab|/r_ab with b = a
// among b, the integral's 2 D S/H^2 where the particles lie in order: half of what the sum alone, which counts each
// neighbour twice, would bound it by. 1.3 is left for disorder. (Poly6 has negative ones, 3 % of the largest.)
template <class Kernel>
double pairwise_diffusion_limit(double diffusivity, const TimeStepInput& in) {
    if (!(diffusivity > 0))
        return std::numeric_limits<double>::infinity();
    const double strength =
        in.dimension == 2 ? pairwise_laplacian_strength<Kernel, 2>() : pairwise_laplacian_strength<Kernel, 3>();
    return in.support_radius * in.support_radius / (1.3 * strength * diffusivity);
}

// The same where only the difference along the line of centres counts, dim times: waves along their own direction decay
// faster, by up to 1.40 in 2D and 1.61 in 3D on lattices of 2 to 4 spacings a support, with any of those kernels.
template <class Kernel>
double central_diffusion_limit(double diffusivity, const TimeStepInput& in) {
    return pairwise_diffusion_limit<Kernel>((in.dimension == 2 ? 1.4 : 1.6) * diffusivity, in);
}

} // namespace imbibe::detail
