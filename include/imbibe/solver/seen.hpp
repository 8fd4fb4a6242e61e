// What others see of a phase that keeps the order of its stress-free configuration: a copy of its columns, sorted by
// cell where its particles are now. Only what has been written since is copied anew.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/solver/phase_store.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace imbibe::detail {

template <int dim, class Real>
class IMBIBE_PER_BUILD Seen {
    using Phase = PhaseStore<dim, Real>;

public:
    /// Sorts the copy by the cells of a grid, into the phase's table of cells.
    void sort(Phase& phase, const search::Grid<dim>& grid, const search::Periodic<dim>& periodic, int threads);
    /// Brings the positions in the copy up to date.
    void refresh_places(const Phase& phase, int threads);
    /// Brings field k of the phase, which is not its position, up to date, if it has been written since.
    void refresh(const Phase& phase, int k, int threads);

    /// Column k of the copy; null before the first search that finds others within reach.
    const Real* column(int k) const {
        const int place = values_.empty() ? -1 : places_[static_cast<std::size_t>(k)];
        return place < 0 ? nullptr : values_.data() + static_cast<std::size_t>(place) * stride_;
    }
    /// Where coordinate d of particle i of the phase is seen, x being where it is, m: in the periodic box.
    IMBIBE_INLINE Real place(int d, int i, Real x) const {
        const auto& outside = periods_outside_[static_cast<std::size_t>(d)];
        return outside.empty() ? x : x - outside[static_cast<std::size_t>(i)];
    }
    /// How far particle i was outside the periodic box at the last search, m, by direction and particle; empty for a
    /// direction that is not periodic. Until the next search it is seen that far from where it is, even if it crosses
    /// a side, because its neighbours were found there.
    const std::array<std::vector<Real>, static_cast<std::size_t>(dim)>& periods_outside() const {
        return periods_outside_;
    }
    std::size_t bytes() const {
        std::size_t numbers = values_.capacity();
        for (const auto& outside : periods_outside_)
            numbers += outside.capacity();
        return numbers * sizeof(Real);
    }

private:
    AlignedVector<Real> values_; // only of the columns that others read
    std::size_t stride_ = 0;
    std::vector<int> places_; // of each of the phase's columns among the copied ones, or -1
    int copied_ = 0;          // how many those are
    std::vector<std::uint32_t> order_;   // place k of the copy has particle order_[k]
    std::vector<std::uint64_t> version_; // of each field, when it was copied
    std::array<std::vector<Real>, static_cast<std::size_t>(dim)> periods_outside_;

    // Where columns [first, first + count) are copied to, which belong to one field; makes room for them.
    int place_of(const Phase& phase, int first, int count);
    void note_periods(const Phase& phase, const search::Periodic<dim>& periodic);
    // Copies columns [first, first + count), in the order of the copy.
    void copy(const Phase& phase, int first, int count, int threads);
};

} // namespace imbibe::detail

#if IMBIBE_READS_CODE
#include <imbibe/solver/seen_code.hpp>
#endif
