// The code of seen.hpp: copies columns in the order of the cells.
#pragma once

#include <imbibe/solver/seen.hpp>

#include <cmath>

namespace imbibe::detail {

template <int dim, class Real>
void Seen<dim, Real>::sort(Phase& phase, const search::Grid<dim>& grid, const search::Periodic<dim>& periodic,
                           int threads) {
    const std::vector<std::uint32_t> order = std::move(order_);
    order_.resize(static_cast<std::size_t>(phase.size()));
    for (std::size_t i = 0; i < order_.size(); ++i)
        order_[i] = static_cast<std::uint32_t>(i);
    note_periods(phase, periodic);
    refresh_places(phase, threads);
    if (!phase.table.sort(grid, phase.points_in(values_, place_of(phase, phase.row->position, dim)), threads)) {
        order_ = phase.table.order();
        refresh_places(phase, threads);
    }
    if (order_ != order)
        version_.clear();
}

template <int dim, class Real>
void Seen<dim, Real>::refresh_places(const Phase& phase, int threads) {
    copy(phase, phase.row->position, dim, threads);
    for (std::size_t d = 0; d < dim; ++d) {
        Real* x = values_.data() +
                  static_cast<std::size_t>(place_of(phase, phase.row->position, dim) + static_cast<int>(d)) * stride_;
        for (std::size_t k = 0; k < periods_outside_[d].size(); ++k)
            x[k] -= periods_outside_[d][order_[k]];
    }
    phase.pad(values_, place_of(phase, phase.row->position, dim), dim);
}

template <int dim, class Real>
void Seen<dim, Real>::refresh(const Phase& phase, int k, int threads) {
    version_.resize(phase.row->fields.size()); // 0: never copied
    std::uint64_t& copied = version_[static_cast<std::size_t>(k)];
    if (copied == phase.version(k))
        return;
    const FieldRow& field = phase.row->fields[static_cast<std::size_t>(k)];
    copy(phase, field.first, field.components, threads);
    copied = phase.version(k);
}

template <int dim, class Real>
void Seen<dim, Real>::note_periods(const Phase& phase, const search::Periodic<dim>& periodic) {
    for (std::size_t d = 0; d < dim; ++d) {
        auto& outside = periods_outside_[d];
        outside.clear();
        if (periodic.length[d] == 0)
            continue;
        const Real low = static_cast<Real>(periodic.lower[d]), length = static_cast<Real>(periodic.length[d]);
        const Real* x = phase.column(phase.row->position + static_cast<int>(d));
        outside.resize(static_cast<std::size_t>(phase.size()));
        for (std::size_t i = 0; i < outside.size(); ++i)
            outside[i] = length * std::round((x[i] - search::into_period(x[i], low, length)) / length);
    }
}

template <int dim, class Real>
int Seen<dim, Real>::place_of(const Phase& phase, int first, int count) {
    if (stride_ != phase.stride()) { // particles have come or gone: nothing is copied yet
        version_.clear();
        places_.assign(static_cast<std::size_t>(phase.row->components), -1);
        copied_ = 0;
        stride_ = phase.stride();
    }
    if (places_[static_cast<std::size_t>(first)] < 0) {
        for (int k = 0; k < count; ++k)
            places_[static_cast<std::size_t>(first + k)] = copied_++;
        values_.resize(stride_ * static_cast<std::size_t>(copied_));
    }
    return places_[static_cast<std::size_t>(first)];
}

template <int dim, class Real>
void Seen<dim, Real>::copy(const Phase& phase, int first, int count, int threads) {
    const int place = place_of(phase, first, count);
    phase.gather(phase.column(first), values_.data() + static_cast<std::size_t>(place) * stride_, count, order_,
                 threads);
    phase.pad(values_, place, count);
}

} // namespace imbibe::detail
