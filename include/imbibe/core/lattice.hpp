// The lattice on which particles are added: what terms compute numbers of that follow from spacing, support radius and
// dimension.
#pragma once

#include <imbibe/core/term.hpp>

#include <cmath>

namespace imbibe {

/// Particles on a square or cubic lattice, all of the same volume, seen by one of them.
/// @tparam dim 2 or 3
template <int dim>
struct Lattice {
    double spacing;        ///< m
    double support_radius; ///< of the term, m

    /// The volume of a particle, m^dim.
    constexpr double volume() const { return power<dim>(spacing); }
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
