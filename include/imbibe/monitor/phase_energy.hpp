// Kinetic and potential energy of a phase with any terms: sums over its columns, by threads and in a fixed order.
#pragma once

#include <imbibe/solver/phase_store.hpp>

#include <array>

namespace imbibe::detail {

/// sum_a m_a |v_a|^2 / 2, J.
template <int dim, class Real>
double kinetic_energy_of(const PhaseStore<dim, Real>& s, int threads) {
    const Real* const m = s.column(s.row->mass);
    const auto block = [&](int begin, int end) {
        double sum = 0;
        for (int i = begin; i < end; ++i) {
            double squared = 0;
            for (int d = 0; d < dim; ++d)
                squared += sq(static_cast<double>(s.column(s.row->velocity + d)[i]));
            sum += 0.5 * static_cast<double>(m[i]) * squared;
        }
        return sum;
    };
    return parallel_reduce(s.size(), threads, 0.0, block, [](double one, double other) { return one + other; });
}

/// - sum_a m_a g.x_a, J, with the origin of the stored coordinates as zero.
template <int dim, class Real>
double potential_energy_of(const PhaseStore<dim, Real>& s, const std::array<double, static_cast<std::size_t>(dim)>& g,
                           int threads) {
    const Real* const m = s.column(s.row->mass);
    const auto block = [&](int begin, int end) {
        double sum = 0;
        for (int i = begin; i < end; ++i) {
            double height = 0;
            for (int d = 0; d < dim; ++d)
                height -= g[static_cast<std::size_t>(d)] * static_cast<double>(s.column(s.row->position + d)[i]);
            sum += static_cast<double>(m[i]) * height;
        }
        return sum;
    };
    return parallel_reduce(s.size(), threads, 0.0, block, [](double one, double other) { return one + other; });
}

} // namespace imbibe::detail
