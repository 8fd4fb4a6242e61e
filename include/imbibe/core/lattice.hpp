// The lattice on which particles are added: terms use it to compute numbers that follow from spacing, support radius
// and dimension.
#pragma once

#include <imbibe/core/term.hpp>

#include <cmath>

namespace imbibe {

/// Particles on a square or cubic lattice, all of the same volume, as one of them sees the others.
/// @tparam dim 2 or 3
template <int dim>
struct Lattice {
    double spacing;        ///< m
    double support_radius; ///< of the term, m

    /// The volume of a particle, m^dim.
    constexpr double volume() const { return power<dim>(spacing); }
    /// G/p, without unit: a pressure p that all particles share, as a force p V_a V_b grad W between each pair, resists
    /// slow shear like an elastic solid of shear modulus G. The larger of the values for shear along the axes and along
    /// the diagonals. It may be negative; then the lattice is unstable.
    ///
    /// The stress of that force is - p M, M = - sum_b V_b x_ab (x) grad_a W_ab, and M is not the identity in a sheared
    /// lattice: G/p = - dM_xy/dgamma. Source: own.
    template <class Kernel>
    double shear_stiffness() const {
        const auto along = [&](double cosine, double sine) {
            return volume() * sum([&](const auto& ab) {
                       const double x = cosine * ab.offset[0] + sine * ab.offset[1],
                                    y = cosine * ab.offset[1] - sine * ab.offset[0], slope = ab.gradient(Kernel{});
                       return sq(y) * (slope + sq(x / ab.distance) * (ab.second_derivative(Kernel{}) - slope));
                   });
        };
        const double axes = along(1, 0), diagonals = along(std::sqrt(0.5), std::sqrt(0.5));
        return std::abs(axes) > std::abs(diagonals) ? axes : diagonals;
    }
    /// The sum of f(ab) over the pairs ab of a particle with its neighbours within the support radius, itself left out;
    /// `ab` is a `Pair<dim, double>` without gravity. In the order of places, the same on every machine.
    template <class F>
    double sum(const F& f) const {
        const SupportRadius support(support_radius);
        const int reach = static_cast<int>(std::ceil(support_radius / spacing));
        int at[3] = {-reach, -reach, dim == 3 ? -reach : 0};
        double all = 0;
        do {
            Vector<double, dim> offset;
            double square = 0;
            for (int d = 0; d < dim; ++d) {
                offset[d] = spacing * at[d];
                square += offset[d] * offset[d];
            }
            if (square > 0 && square < support_radius * support_radius)
                all += f(Pair<dim, double>(offset, std::sqrt(square), support, {}));
            for (int d = 0; d < dim && ++at[d] > reach; ++d)
                at[d] = d + 1 < dim ? -reach : at[d];
        } while (at[dim - 1] <= reach);
        return all;
    }
};

} // namespace imbibe
