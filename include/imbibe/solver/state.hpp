// The particles of one phase: one stretch of memory per component of each field (structure of arrays), and the
// order in which they lie there.
#pragma once

#include <imbibe/core/memory.hpp>
#include <imbibe/search/neighbours.hpp>
#include <imbibe/solver/composition.hpp>
#include <imbibe/solver/loops.hpp>
#include <imbibe/solver/rules.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

namespace imbibe::detail {

/// The values of one field of all particles: n rows, one column per component. Their order in memory is said here, as a
/// host may have changed Eigen's default (EIGEN_DEFAULT_TO_ROW_MAJOR).
template <class Real, int columns>
using FieldValues = Eigen::Matrix<Real, Eigen::Dynamic, columns, Eigen::ColMajor>;

/// Eigen's view of one field of all particles, no copy.
/// @tparam Numbers FieldValues or const FieldValues
template <class Numbers>
using FieldView = Eigen::Map<Numbers, 0, Eigen::OuterStride<>>;

/// @tparam List the fields of the phase
template <class P, class List, int dim, class Real>
class IMBIBE_PER_BUILD PhaseState {
public:
    static constexpr int component_total = component_count<dim, List>;
    template <class F>
    static constexpr int offset = component_offset<dim, F, List>;
    template <class F>
    static constexpr bool stores = contains<F, List>;
    static constexpr bool keeps_reference = stores<ReferencePosition>;

    P material{};
    std::vector<std::uint32_t> ids; ///< the number of each particle in the order in which they were added

    int size() const { return n; }
    Real* data() { return values.data(); }
    const Real* data() const { return values.data(); }
    std::size_t stride() const { return step; }
    /// Component k of the phase's fields, for all particles.
    Real* column(int k) { return values.data() + static_cast<std::size_t>(k) * step; }
    const Real* column(int k) const { return values.data() + static_cast<std::size_t>(k) * step; }
    template <class F>
    Real* field(F) {
        return column(offset<F>);
    }
    template <class F>
    const Real* field(F) const {
        return column(offset<F>);
    }
    template <class F>
    auto view(F) {
        check_stored<F>();
        constexpr int columns = components(F::rank, dim);
        return FieldView<FieldValues<Real, columns>>(field(F{}), n, columns,
                                                     Eigen::OuterStride<>(static_cast<Eigen::Index>(step)));
    }
    template <class F>
    auto view(F) const {
        check_stored<F>();
        constexpr int columns = components(F::rank, dim);
        return FieldView<const FieldValues<Real, columns>>(field(F{}), n, columns,
                                                           Eigen::OuterStride<>(static_cast<Eigen::Index>(step)));
    }
    search::Points<dim, Real> points() const { return points_of(position); }
    template <class F>
    search::Points<dim, Real> points_of(F) const {
        search::Points<dim, Real> p;
        p.n = n;
        for (int d = 0; d < dim; ++d)
            p.x[static_cast<std::size_t>(d)] = column(offset<F> + d);
        return p;
    }

    /// Changes the number of particles; the values of those that stay are kept, new ones are zero.
    void resize(int count) {
        ids.reserve(static_cast<std::size_t>(count)); // nothing has changed where there is no memory
        disturbed = true;
        const std::size_t wanted = stride_for(count);
        if (wanted != step) {
            AlignedVector<Real> grown(wanted * static_cast<std::size_t>(component_total), Real(0));
            for (int k = 0; k < component_total; ++k)
                std::copy_n(column(k), std::min(n, count), grown.data() + static_cast<std::size_t>(k) * wanted);
            values.swap(grown);
            spare.clear();
            image.clear();
            step = wanted;
        }
        for (int k = 0; k < component_total; ++k)
            std::fill(column(k) + std::min(n, count), column(k) + step, Real(0));
        n = count;
        const std::size_t known = ids.size();
        ids.resize(static_cast<std::size_t>(n));
        for (std::size_t i = known; i < ids.size(); ++i)
            ids[i] = next_id++;
    }

    /// How many particles were ever added.
    long long ever_added() const { return next_id; }

    /// Puts the particles into a new order: particle order[k] moves to k. All components are carried along.
    void reorder(const std::vector<std::uint32_t>& order, int threads) {
        spare.resize(values.size());
        gather(column(0), spare.data(), component_total, order, threads);
        values.swap(spare);
        std::memcpy(spare.data(), ids.data(), ids.size() * sizeof(ids[0])); // what `spare` held is of no use any more
        const auto* const before = reinterpret_cast<const std::byte*>(spare.data());
        ids.resize(order.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            std::memcpy(&ids[i], before + order[i] * sizeof(ids[0]), sizeof(ids[0]));
        n = static_cast<int>(order.size());
        pad();
    }

    /// Keeps only the particles for which keep[i] is true.
    void compress(const std::vector<char>& keep) {
        disturbed = true;
        std::vector<std::uint32_t> order;
        for (int i = 0; i < n; ++i)
            if (keep[static_cast<std::size_t>(i)])
                order.push_back(static_cast<std::uint32_t>(i));
        reorder(order, 1);
    }

    /// Pair loops load whole packs, also beyond the last particle. What they find there is masked, but must be legal
    /// numbers in any formula (a density of zero is not): copies of the last particle. To be called after writing.
    void pad() { pad(values); }

    // ---- places at the last search, of a phase that only a host moves ----
    /// Keeps a copy of the positions.
    void remember_places() { places_then.assign(column(offset<Position>), column(offset<Position>) + dim * step); }
    /// How far the particle is that has moved farthest since, m.
    double farthest_since(int threads) const {
        const Real *now = column(offset<Position>), *then = places_then.data();
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

    // ---- the sorted copy through which others see a phase that keeps its reference order ----
    /// Notes how far each particle is outside the periodic box, in whole periods, at a search: until the next one it is
    /// seen that far from where it is, whatever sides it crosses meanwhile, for so its neighbours were found.
    void note_periods(const search::Periodic<dim>& periodic) {
        for (std::size_t d = 0; d < dim; ++d) {
            auto& outside = periods_outside[d];
            outside.clear();
            if (periodic.length[d] == 0)
                continue;
            const Real low = static_cast<Real>(periodic.lower[d]), length = static_cast<Real>(periodic.length[d]);
            const Real* x = column(offset<Position> + static_cast<int>(d));
            outside.resize(static_cast<std::size_t>(n));
            for (std::size_t i = 0; i < outside.size(); ++i)
                outside[i] = length * std::round((x[i] - search::into_period(x[i], low, length)) / length);
        }
    }
    /// Where others see coordinate d of particle i, if the phase keeps its reference order, m.
    IMBIBE_INLINE Real seen_at(int d, int i) const {
        const Real x = column(offset<Position> + d)[i];
        const auto& outside = periods_outside[static_cast<std::size_t>(d)];
        return outside.empty() ? x : x - outside[static_cast<std::size_t>(i)];
    }
    /// Brings the positions in the copy up to date.
    void copy_places_to_image(int threads) {
        copy_to_image(offset<Position>, dim, threads);
        for (std::size_t d = 0; d < dim; ++d) {
            Real* x = image_column(offset<Position> + static_cast<int>(d));
            for (std::size_t k = 0; k < periods_outside[d].size(); ++k)
                x[k] -= periods_outside[d][image_order[k]];
        }
        pad(image);
    }
    /// Copies components [first, first + count) into the copy, in the order of the cell table.
    void copy_to_image(int first, int count, int threads) {
        image.resize(values.size());
        gather(column(first), image.data() + static_cast<std::size_t>(first) * step, count, image_order, threads);
        pad(image);
    }
    search::Points<dim, Real> image_points() const {
        search::Points<dim, Real> p;
        p.n = n;
        for (int d = 0; d < dim; ++d)
            p.x[static_cast<std::size_t>(d)] = image_column(offset<Position> + d);
        return p;
    }
    Real* image_column(int k) { return image.data() + static_cast<std::size_t>(k) * step; }
    /// The same, to read; null before the first search that finds others within reach.
    const Real* image_column(int k) const {
        return image.empty() ? nullptr : image.data() + static_cast<std::size_t>(k) * step;
    }

    /// periods_outside[d][i]: see note_periods, m; empty for a direction that is not periodic.
    std::array<std::vector<Real>, static_cast<std::size_t>(dim)> periods_outside;

    search::CellTable table;                ///< of the present positions
    std::vector<std::uint32_t> image_order; ///< image[k] is particle image_order[k]
    search::Bounds<dim> bounds;
    bool within_reach = true; ///< of any other, at the last search? If not, the copy and the table are not kept up
    bool disturbed = true;    ///< were particles added or removed since their neighbours were found?
    std::size_t bytes() const {
        std::size_t numbers = values.capacity() + spare.capacity() + image.capacity() + places_then.capacity();
        for (const auto& outside : periods_outside)
            numbers += outside.capacity();
        return numbers * sizeof(Real) + ids.capacity() * sizeof(std::uint32_t);
    }

    /// Bytes that `archive` writes or reads for one particle.
    static constexpr std::size_t bytes_per_archived_particle =
        sizeof(std::uint32_t) + sizeof(Real) * static_cast<std::size_t>(component_total);
    /// All particles as they lie in memory, for checkpoints. `count`: how many, known before.
    template <class Archive>
    void archive(Archive& a, int count) {
        if constexpr (Archive::reading) {
            resize(count);
            ids.resize(static_cast<std::size_t>(count));
        }
        a(next_id);
        a.array(ids.data(), ids.size());
        for (int k = 0; k < component_total; ++k)
            a.array(column(k), static_cast<std::size_t>(n));
        if constexpr (Archive::reading)
            pad();
    }

private:
    // One error where a phase has no such field.
    template <class F>
    static constexpr void check_stored() {
        if constexpr (!stores<F>)
            break_rule<rules::FieldNotStored<F, P, list_a_term_that_uses_it_or_look_at_another>>();
    }
    // Room for the widest pack beyond the end, and an odd number of cache lines, so that the same particle's
    // components do not compete for one place in the cache.
    static std::size_t stride_for(int count) {
        constexpr std::size_t line = 64 / sizeof(Real);
        std::size_t lines = (static_cast<std::size_t>(count) + search::read_beyond) / line + 1;
        return (lines | 1) * line;
    }
    // to[k] = from[order[k]] in each of `count` components.
    void gather(const Real* from, Real* to, int count, const std::vector<std::uint32_t>& order, int threads) const {
        const auto block = [&](int begin, int end) {
            for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k)
                for (int i = begin; i < end; ++i)
                    (to + k * step)[i] = (from + k * step)[order[static_cast<std::size_t>(i)]];
        };
        loop_blocks(static_cast<int>(order.size()), 4096, threads, Callable<void(int, int)>(block));
    }
    void pad(AlignedVector<Real>& columns) {
        constexpr int lanes = 64 / sizeof(Real);
        if (n == 0)
            return;
        for (int k = 0; k < component_total; ++k) {
            Real* end = columns.data() + static_cast<std::size_t>(k) * step + n;
            std::fill_n(end, lanes, end[-1]);
        }
    }
    int n = 0;
    std::size_t step = 0;
    std::uint32_t next_id = 0;
    AlignedVector<Real> values, spare, image;
    std::vector<Real> places_then;
};

} // namespace imbibe::detail
