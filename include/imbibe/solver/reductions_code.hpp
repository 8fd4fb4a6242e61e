// The code of reductions.hpp: reduces blocks of particles and puts them together.
#pragma once

#include <imbibe/solver/reductions.hpp>

namespace imbibe::detail {

template <int dim, class Real>
double reduced(const PhaseStore<dim, Real>& phase, const Reduction<dim, Real>& row, int threads) {
    const auto block = [&](int begin, int end) { return row.body(phase, begin, end); };
    return parallel_reduce(phase.size(), threads, row.of_none, block, row.both);
}

} // namespace imbibe::detail
