// The code of phase_store.hpp: moves columns about.
#pragma once

#include <imbibe/solver/phase_store.hpp>

namespace imbibe::detail {

template <int dim, class Real>
void PhaseStore<dim, Real>::resize(int count) {
    ids.reserve(static_cast<std::size_t>(count)); // first: without memory, nothing has changed
    disturbed = true;
    note_all_written();
    const std::size_t wanted = stride_for(count);
    if (wanted != step) {
        AlignedVector<Real> larger(wanted * columns(), Real(0));
        for (int k = 0; k < row->components; ++k)
            std::copy_n(column(k), std::min(n, count), larger.data() + static_cast<std::size_t>(k) * wanted);
        values.swap(larger);
        spare.clear();
        step = wanted;
    }
    for (int k = 0; k < row->components; ++k)
        std::fill(column(k) + std::min(n, count), column(k) + step, Real(0));
    n = count;
    const std::size_t known = ids.size();
    ids.resize(static_cast<std::size_t>(n));
    for (std::size_t i = known; i < ids.size(); ++i)
        ids[i] = next_id++;
}

template <int dim, class Real>
void PhaseStore<dim, Real>::reorder(const std::vector<std::uint32_t>& order, int threads) {
    spare.resize(values.size());
    gather(column(0), spare.data(), row->components, order, threads);
    values.swap(spare);
    std::memcpy(spare.data(), ids.data(), ids.size() * sizeof(ids[0])); // what `spare` held is of no use any more
    const auto* const before = reinterpret_cast<const std::byte*>(spare.data());
    ids.resize(order.size());
    const auto block = [&](int begin, int end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
            std::memcpy(&ids[i], before + order[i] * sizeof(ids[0]), sizeof(ids[0]));
    };
    n = static_cast<int>(order.size());
    loop_blocks(n, 4096, threads, Callable<void(int, int)>(block));
    pad();
    if (row->keeps_reference()) // it stays in this order: no other one is made
        AlignedVector<Real>().swap(spare);
}

template <int dim, class Real>
void PhaseStore<dim, Real>::compress(const std::vector<char>& keep) {
    disturbed = true;
    std::vector<std::uint32_t> order;
    for (int i = 0; i < n; ++i)
        if (keep[static_cast<std::size_t>(i)])
            order.push_back(static_cast<std::uint32_t>(i));
    reorder(order, 1);
}

template <int dim, class Real>
double PhaseStore<dim, Real>::farthest_since(int threads) const {
    const Real *now = column(row->position), *then = places_then.data();
    const auto block = [&](int begin, int end) {
        double farthest2 = 0;
        for (int i = begin; i < end; ++i) {
            double way2 = 0;
            for (std::size_t k = static_cast<std::size_t>(i); k < dim * step; k += step)
                way2 += sq(static_cast<double>(now[k]) - static_cast<double>(then[k]));
            farthest2 = std::max(farthest2, way2);
        }
        return farthest2;
    };
    return std::sqrt(greatest_of_blocks(n, threads, Callable<double(int, int)>(block)));
}

template <int dim, class Real>
void PhaseStore<dim, Real>::gather(const Real* from, Real* to, int count, const std::vector<std::uint32_t>& order,
                                   int threads) const {
    const auto block = [&](int begin, int end) {
        for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k)
            for (int i = begin; i < end; ++i)
                (to + k * step)[i] = (from + k * step)[order[static_cast<std::size_t>(i)]];
    };
    loop_blocks(static_cast<int>(order.size()), 4096, threads, Callable<void(int, int)>(block));
}

template <int dim, class Real>
void PhaseStore<dim, Real>::pad(AlignedVector<Real>& to, int first, int count) const {
    constexpr int lanes = 64 / sizeof(Real);
    if (n == 0)
        return;
    for (int k = first; k < first + count; ++k) {
        Real* end = to.data() + static_cast<std::size_t>(k) * step + n;
        std::fill_n(end, lanes, end[-1]);
    }
}

} // namespace imbibe::detail
