// The particles of one phase: a contiguous column per component of each field (structure of arrays), and the order of
// the particles in them. The phase's row in the tables of the scene says which column is which. seen.hpp has the copy
// that others see of a phase that stays in its own order.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/core/error.hpp>
#include <imbibe/core/memory.hpp>
#include <imbibe/search/neighbours.hpp>
#include <imbibe/solver/loops.hpp>
#include <imbibe/solver/tables.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

namespace imbibe::detail {

/// How fast a phase moves.
struct Motion {
    double speed = 0;             ///< the greatest speed in the scene's frame (SceneStore::frame), m/s
    double acceleration = 0;      ///< the greatest acceleration, m/s^2
    double fastest = 0;           ///< the greatest velocity, without change of frame, m/s
    std::array<double, 3> mean{}; ///< of the velocities, m/s
};

template <int dim, class Real>
class IMBIBE_PER_BUILD PhaseStore {
public:
    using Number = Real;
    static constexpr int dimension = dim;

    const PhaseRow* row = nullptr;
    std::string name;               ///< of the phase, among all of the scene
    std::any material;              ///< an object of the phase's type
    std::vector<std::uint32_t> ids; ///< the number of each particle in the order in which they were added
    Motion motion;
    double travelled = 0; ///< an upper bound of its particles' displacement since the last search, m

    explicit PhaseStore(const PhaseRow& of) : row(&of), name(of.name()), material(of.material()) {}

    PhaseNumbers numbers() const { return row->numbers(material); }
    int size() const { return n; }
    /// The density of the material of particle i, kg/m^3: in the pores of a skeleton not that per total volume.
    double own_density(int i) const {
        const double share = row->porosity >= 0 ? static_cast<double>(column(row->porosity)[i]) : 1; // 0: not set yet
        return static_cast<double>(column(row->density)[i]) / (share > 0 ? share : 1);
    }
    Real* data() { return values.data(); }
    const Real* data() const { return values.data(); }
    std::size_t stride() const { return step; }
    /// Component k of the phase's fields, for all particles.
    Real* column(int k) { return values.data() + static_cast<std::size_t>(k) * step; }
    const Real* column(int k) const { return values.data() + static_cast<std::size_t>(k) * step; }
    /// The same, or null for a field that is not stored.
    const Real* column_if(int k) const { return k < 0 ? nullptr : column(k); }
    search::Points<dim, Real> points() const { return points_of(row->position); }
    /// A vector field as points.
    search::Points<dim, Real> points_of(int first) const { return points_in(values, first); }

    /// Changes the number of particles; the values of those that stay are kept, new ones are zero.
    void resize(int count);

    /// How many particles were ever added.
    long long ever_added() const { return next_id; }

    /// Puts the particles into a new order: particle order[k] moves to k. All components are carried along.
    void reorder(const std::vector<std::uint32_t>& order, int threads);

    /// Keeps only the particles for which keep[i] is true.
    void compress(const std::vector<char>& keep);

    /// Pair loops load whole packs, also beyond the last particle. These values are masked, but must be legal in any
    /// formula (a density of zero is not): they are copies of the last particle. To be called after writing.
    void pad() { pad(values, 0, row->components); }

    // ---- positions at the last search, of a phase that only a host moves ----
    /// Keeps a copy of the positions.
    void remember_places() { places_then.assign(column(row->position), column(row->position) + dim * step); }
    /// The greatest displacement of any particle since then, m.
    double farthest_since(int threads) const;

    // ---- what was written ----
    /// Notes that the field that begins at a column was written, so that copies of it are updated.
    void note_written(int first) {
        for (std::size_t k = 0; k < writes_.size(); ++k)
            if (row->fields[k].first == first)
                ++writes_[k];
    }
    /// The same for all fields.
    void note_all_written() { ++writes_of_all_; }
    /// A number that grows whenever field k is written; above 0.
    std::uint64_t version(int k) const { return writes_of_all_ + writes_[static_cast<std::size_t>(k)]; }

    // ---- for copies of columns ----
    /// to[k] = from[order[k]] in each of `count` columns that are a stride apart.
    void gather(const Real* from, Real* to, int count, const std::vector<std::uint32_t>& order, int threads) const;
    /// Pads columns [first, first + count) of numbers that are laid out as the phase's.
    void pad(AlignedVector<Real>& to, int first, int count) const;
    /// A vector field among such numbers as points.
    search::Points<dim, Real> points_in(const AlignedVector<Real>& from, int first) const {
        search::Points<dim, Real> p;
        p.n = n;
        for (std::size_t d = 0; d < dim; ++d)
            p.x[d] = from.data() + (static_cast<std::size_t>(first) + d) * step;
        return p;
    }

    search::CellTable table; ///< of the present positions
    search::Bounds<dim> bounds;
    bool within_reach = true; ///< of any other, at the last search? If not, its table is not updated
    bool disturbed = true;    ///< were particles added or removed since their neighbours were found?
    bool grown = true;        ///< were any added since the last evaluation of what is computed once?

    // ---- what integrators keep from the begin of a step ----
    AlignedVector<Real> remembered; ///< positions, velocities and states, in this order
    AlignedVector<Real> kept_sums;  ///< see Mover::keep_sums

    std::size_t bytes() const {
        const std::size_t numbers = values.capacity() + spare.capacity() + places_then.capacity();
        return numbers * sizeof(Real) + ids.capacity() * sizeof(std::uint32_t);
    }

    /// Bytes that `archive` writes or reads for one particle.
    std::size_t bytes_per_archived_particle() const { return sizeof(std::uint32_t) + sizeof(Real) * columns(); }
    /// Throws Error if the data that `archive` would read for `count` particles make no sense. Moves past them.
    template <class Archive>
    void check_archived(Archive& a, std::uint64_t count) const {
        std::uint32_t ever = 0;
        std::vector<std::uint32_t> numbers(count);
        a(ever);
        a.array(numbers.data(), numbers.size());
        for (const std::uint32_t number : numbers)
            require(number < ever, "checkpoint: phase ", name, " has a particle of number ", number, " where only ",
                    ever, " were ever added; take the checkpoint before it");
        a.skip(count * columns(), sizeof(Real));
    }
    /// All particles as they lie in memory, for checkpoints. `count`: their number, known before.
    template <class Archive>
    void archive(Archive& a, int count) {
        if constexpr (Archive::reading) {
            resize(count);
            ids.resize(static_cast<std::size_t>(count));
        }
        a(next_id);
        a.array(ids.data(), ids.size());
        for (int k = 0; k < row->components; ++k)
            a.array(column(k), static_cast<std::size_t>(n));
        if constexpr (Archive::reading)
            pad();
    }

private:
    std::size_t columns() const { return static_cast<std::size_t>(row->components); }
    // Room for the widest pack beyond the end, and an odd number of cache lines, so that the components of a particle
    // do not compete for one place in the cache.
    static std::size_t stride_for(int count) {
        constexpr std::size_t line = 64 / sizeof(Real);
        std::size_t lines = (static_cast<std::size_t>(count) + search::read_beyond) / line + 1;
        return (lines | 1) * line;
    }
    int n = 0;
    std::size_t step = 0;
    std::uint32_t next_id = 0;
    AlignedVector<Real> values, spare;
    std::uint64_t writes_of_all_ = 1;
    std::vector<std::uint64_t> writes_ = std::vector<std::uint64_t>(row->fields.size());
    std::vector<Real> places_then;
};

} // namespace imbibe::detail

#if IMBIBE_READS_CODE
#include <imbibe/solver/phase_store_code.hpp>
#endif
