// The repulsion that keeps water and sponge apart, stiff as a pressure K_f.
//
// The paper's coupling is three terms between two phases:
//   struct Contact : Coupling<Water, Sponge, SymmetricPressure<Spiky>, LaminarViscosity<>, KernelRepulsion<>> {};
// The first two are the terms of the fluid itself. Between phases they give, pair by pair, the force
//   F_ab = - m_a m_b (p_a/rho_a^2 + p_b/rho_b^2) grad_a W + eta V_a V_b (v_b - v_a) Laplacian W,   V = m/rho,
// which changes sign when a and b are exchanged. This is Eq. (23) in its consistent reading: with the printed factor
// rho_b and without 1/rho_b in the viscous part, action and reaction differ (by 11 % at the paper's densities). It is
// also Eq. (25) for every pair, not only for the sums.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/term.hpp>
#include <imbibe/kernels/spiky.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace imbibe {

/// Coefficients of KernelRepulsion.
struct KernelRepulsionParameters {
    /// K_f, Pa. The force is that of a pressure of this size on overlapping kernels.
    double stiffness = 1e8;
    /// Range of the repulsion, in means of the two particle spacings, at most the support radius; 0: the support
    /// radius, as in the paper. With 0.7 only particles that have come too near are pushed back; otherwise nothing
    /// changes.
    double range = 0;

    /// Throws Error for a number out of range. @param where the phase or coupling in the message
    void check(std::string_view where) const {
        require_not_negative(stiffness, where, "KernelRepulsionParameters::stiffness", "Pa");
        require_not_negative(range, where, "KernelRepulsionParameters::range", "spacings");
    }
};

/// dv_a/dt = - K_f/m_a sum_b V_a V_b grad_a W_ab, in m/s^2, with the volumes V = m/rho. W has the support radius H of
/// the two phases, or `range` spacings.
///
/// In couplings: keeps two phases apart if the pressure alone does not. The force of the pair is along the line of
/// centres, repulsive (W falls with distance), equal and opposite, to the last bit where the masses are equal. 1e8 Pa
/// at half the support radius is 4.5e7 m/s^2 per neighbour in the paper's scene.
///
/// With a `range` below 1 and a small K_f it is a guard for couplings whose pressure keeps the phases apart on average,
/// but not every particle. Where a film or a jet of water is stretched along a surface, its density stays constant
/// while its particles approach the surface and finally sink in. In the scene of the sponge 0.7 spacings keep them out,
/// at any K_f from 1e3 to 1e5 Pa with the same outcome. As a term of the fluid it does the same for the particles of
/// such a film or jet, which approach each other across it and end in pairs. While particles are in order it changes
/// nothing.
///
/// Not with the full range for an accurate contact: the gap it leaves is near the support radius (0.93 H in the paper's
/// scene) and depends on K_f and H, and energy goes in and out of it in each impact. Not with a kernel whose slope
/// vanishes at the centre: it would hold particles that have come through.
///
/// Source: the paper, Eq. (24), with two slips mended: the printed sign attracts, and it belongs to the force, Eq.
/// (23), not to the density, Eq. (22).
template <class Kernel = Spiky>
struct KernelRepulsion {
    using Parameters = KernelRepulsionParameters;
    using reads = Fields<mass, density>;
    using adds = Fields<acceleration>;
    Parameters parameters{};

    IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        // Pairs further apart than that do not count.
        const double reach = parameters.range * 0.5 * (a.material.spacing + b.material.spacing);
        const auto pair = parameters.range > 0 ? ab.within(reach) : ab;
        return along(ab, -(parameters.stiffness * b[mass] / (a[density] * b[density])) * pair.gradient(Kernel{}));
    }

    /// Throws Error for a range within a solid that includes a particle's neighbours in the body itself: they would be
    /// pushed apart permanently. @param owner a phase or coupling, @param where its name in the message
    static void check(const auto& owner, std::string_view where) {
        if constexpr (requires { owner.shear_modulus; }) {
            const Parameters& set = owner.coefficients.template get<Parameters>();
            require(set.stiffness == 0 || (set.range > 0 && set.range <= 1), where,
                    ": KernelRepulsionParameters::range = ", set.range, " spacings",
                    set.range == 0 ? ", the whole support," : "",
                    " pushes the neighbours in a body apart; within a solid it must be above 0 and at most 1, 0.9 say");
        }
    }

    static constexpr const char* limit_name = "repulsion stiffness";
    /// Within one phase: sqrt(m/k) min(1, (1.25/r)^(dim/2)), s, with the mass m of a particle, the greatest stiffness k
    /// that a pair has at any distance, which is 90 K_f V^2/(pi H^5) for Spiky in 3D, and the reach r in spacings.
    ///
    /// A symplectic step is stable below 2 over the highest frequency omega: m omega^2 is the greatest eigenvalue of
    /// sum_b K_ab (1 - cos(q.x_ab)) over all wave vectors q, with K_ab = W'' n n^T + W'/|x| (1 - n n^T) of a pair. In a
    /// row of particles that see only the next one it is 4 k; a particle that sees more is held by all of them, whose
    /// number grows as r^dim. On square, hexagonal, cubic and face-centred lattices with reaches from 1.1 to 4 spacings
    /// the limit is at most 0.55 (Spiky, CubicSpline) and 0.4 (WendlandC2) of the longest stable step; what is left is
    /// for disorder. (Poly6: 1.07. tests/terms/test_coupling.cpp has the square and the cubic lattice.)
    static double time_step_limit(const auto& material, const TimeStepInput& in, const Parameters& parameters) {
        const double cell = std::pow(in.spacing, in.dimension), reach = reach_of(in, in.spacing, parameters);
        const double k = energy_scale(cell, cell, reach, in.dimension, parameters) / sq(reach) *
                         greatest_curvature(std::numeric_limits<double>::infinity());
        const double many = std::pow(std::min(1.0, 1.25 * in.spacing / reach), 0.5 * in.dimension);
        return k > 0 ? std::sqrt(material.density * cell / k) * many : std::numeric_limits<double>::infinity();
    }
    /// Its limit in a coupling depends on the nearest pair (TimeStepInput::nearest).
    static constexpr bool limit_by_nearest = true;
    /// 2 sqrt(m/k), s, with the reduced mass m of a pair and its greatest stiffness k during an impact.
    ///
    /// The potential of a pair is K_f V_a V_b W. A particle of the heavier phase with the sum of the two phases'
    /// greatest speeds, starting as near as the nearest pair, penetrates until W has taken up its energy; k is the
    /// largest K_f V_a V_b |d2W/dr2| on the way from the rim. For Spiky in 3D and a pair that comes from afar this is k
    /// = 90 K_f V_a V_b delta/(pi H^6) with the penetration delta = H (pi H^3 m v^2/(30 K_f V_a V_b))^(1/3) <= H.
    /// Infinite if nothing moves and nothing is in reach. A particle in contact with several others is held by all of
    /// them: water on a soft solid with K_f = 1e8 Pa bears half of this (longest_stable_step), still more than the
    /// default CFL number takes.
    static double time_step_limit(const auto& material_a, const auto& material_b, const TimeStepInput& in,
                                  const Parameters& parameters) {
        const double volume_a = std::pow(in.spacing, in.dimension), mass_a = material_a.density * volume_a;
        const double volume_b = std::pow(in.other_spacing, in.dimension), mass_b = material_b.density * volume_b;
        const double energy = 0.5 * std::max(mass_a, mass_b) * sq(in.max_speed + in.other_max_speed);
        const double reach = reach_of(in, in.other_spacing, parameters);
        const double scale = energy_scale(volume_a, volume_b, reach, in.dimension, parameters);
        const double taken = in.nearest < reach ? Kernel::value(in.nearest / reach) : 0.0;
        const double k = scale / sq(reach) * greatest_curvature(energy / scale + taken);
        const double reduced_mass = mass_a * mass_b / (mass_a + mass_b);
        return k > 0 ? 2 * std::sqrt(reduced_mass / k) : std::numeric_limits<double>::infinity();
    }

private:
    // The range between particles of the first phase and others `other_spacing` apart, m.
    static double reach_of(const TimeStepInput& in, double other_spacing, const Parameters& parameters) {
        const double own = parameters.range * 0.5 * (in.spacing + other_spacing);
        return own > 0 ? std::min(own, in.support_radius) : in.support_radius;
    }

    // The factor of the kernel's shape w(q) in the potential of a pair, J.
    static double energy_scale(double volume_a, double volume_b, double reach, int dimension,
                               const Parameters& parameters) {
        const double normalisation =
            dimension == 2 ? Kernel::template normalisation<2>() : Kernel::template normalisation<3>();
        return parameters.stiffness * volume_a * volume_b * normalisation / std::pow(reach, dimension);
    }

    // The largest |w''(q)| from the rim q = 1 inwards to where w(q) reaches `level`, or to the centre.
    static double greatest_curvature(double level) {
        if (!(level > 0)) // nothing moves, or there is no repulsion
            return 0;
        double inside = 0, outside = 1;
        for (int k = 0; k < 50; ++k) {
            const double q = 0.5 * (inside + outside);
            (Kernel::value(q) > level ? inside : outside) = q;
        }
        constexpr int samples = 32;
        constexpr double step = 1e-4;
        double curvature = 0;
        for (int k = 0; k < samples; ++k) {
            const double q = std::max(inside + (1 - inside) * k / samples, step);
            const double slope_change = Kernel::derivative(q + step) - Kernel::derivative(q - step);
            curvature = std::max(curvature, std::abs(slope_change) / (2 * step));
        }
        return curvature;
    }
};

} // namespace imbibe
