// A scene as its checks see it, for any dimension, number type and terms: phases with name, kind, spacing and particle
// positions. Checks on outlines are ordinary code, which no scene compiles anew.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/core/error.hpp>
#include <imbibe/solver/loops.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace imbibe::detail {

/// A place in the plane (its third coordinate is 0) or in space, m.
using Coordinates = std::array<double, 3>;

/// The columns of a vector field of n particles, in float or double.
struct OutlineColumns {
    std::array<const void*, 3> x{}; ///< of each dimension; null beyond
    int n = 0;
    bool in_float = false;

    double at(std::size_t d, int i) const {
        return in_float ? static_cast<double>(static_cast<const float*>(x[d])[i]) : static_cast<const double*>(x[d])[i];
    }
    Coordinates at(int i) const {
        Coordinates place{};
        for (std::size_t d = 0; d < 3 && x[d] != nullptr; ++d)
            place[d] = at(d, i);
        return place;
    }
};

/// What moves the particles of a phase, and what acts between them.
enum class Kind { fluid, solid, wall };

/// A phase.
struct Outline {
    std::string name;
    Kind kind = Kind::wall;
    double spacing = 0, support_radius = 0; ///< m
    OutlineColumns now;                     ///< present positions, without the origin, m
    OutlineColumns at_rest;                 ///< stress-free positions in a total-Lagrangian phase; else `now`
    OutlineColumns mobility;                ///< 0 for held particles; no column if none can be held
    const std::uint32_t* ids = nullptr;     ///< ids[i] is the number particle i had when it was added
    long long ever_added = 0;               ///< all ids are below
    bool knows_bodies = false;              ///< is it total-Lagrangian without interaction between its bodies?

    int size() const { return now.n; }
};

/// Properties that phases share.
struct OutlineOfScene {
    std::vector<Outline> phases;
    int dim = 3;
    Coordinates origin{};          ///< of all places, m
    Coordinates lower{}, period{}; ///< the periodic sides, m; a period of 0: none
    int threads = 1;

    const Outline& operator[](int k) const { return phases[static_cast<std::size_t>(k)]; }
    /// "(0.1, 0.2) m", in world coordinates.
    std::string text_of(const Coordinates& place) const {
        std::string words = "(";
        for (std::size_t d = 0; d < static_cast<std::size_t>(dim); ++d)
            words += text(d == 0 ? "" : ", ", place[d] + origin[d]);
        return words + ") m";
    }
};

/// Two phases of a scene by their numbers, and the reach between them, m.
struct PhasePair {
    int first, second;
    double reach;
    bool coupled;
};

/// The smallest box around some places.
struct OutlineBox {
    Coordinates lower{1e300, 1e300, 1e300}, upper{-1e300, -1e300, -1e300};

    void include(const Coordinates& x) {
        for (std::size_t d = 0; d < 3; ++d) {
            lower[d] = std::min(lower[d], x[d]);
            upper[d] = std::max(upper[d], x[d]);
        }
    }
    /// Is a place within `reach` of the box, judged along the sides that are not periodic?
    bool is_near(const Coordinates& x, double reach, const Coordinates& period) const {
        for (std::size_t d = 0; d < 3; ++d)
            if (period[d] == 0 && !(x[d] >= lower[d] - reach && x[d] <= upper[d] + reach))
                return false;
        return true;
    }
};
OutlineBox box_around(const OutlineColumns& columns);

/// Places sorted into cells, to look up which are near another. For checks; the search of a run is in search/.
class PlacesByCell {
    using Cell = std::array<long long, 3>;

public:
    /// @param reach the search radius, m; at most a period, so that no place is found twice
    PlacesByCell(const std::vector<Coordinates>& places, double reach, const OutlineOfScene& scene);
    /// The places in the order of the cells: looked up in this order, each reuses the cells of the one before.
    const std::vector<int>& order() const { return numbers_; }

    /// Looks up places near others, one after the other. For one thread.
    class Lookup {
    public:
        explicit Lookup(const PlacesByCell& cells) : cells_(cells) {}
        /// Calls f(j, offset, distance) for every place j nearer to x than the reach; `offset` is the vector to x from
        /// j, or from its image, m.
        template <class F>
        void for_each_near(const Coordinates& x, const F& f) {
            const Coordinates here = cells_.wrapped(x);
            if (const Cell own = cells_.cell_of(here); ranges_.empty() || own != own_) {
                own_ = own;
                find_ranges();
            }
            for (const auto& [begin, end] : ranges_)
                for (std::size_t k = begin; k < end; ++k) {
                    const Coordinates& there = cells_.places_[k];
                    Coordinates offset;
                    double distance2 = 0;
                    for (std::size_t d = 0; d < 3; ++d) {
                        offset[d] = here[d] - there[d];
                        if (cells_.period_[d] > 0)
                            offset[d] -= cells_.period_[d] * std::round(offset[d] / cells_.period_[d]);
                        distance2 += offset[d] * offset[d];
                    }
                    if (distance2 < cells_.reach_ * cells_.reach_)
                        f(cells_.numbers_[k], offset, std::sqrt(distance2));
                }
        }

    private:
        const PlacesByCell& cells_;
        Cell own_{};
        std::vector<std::pair<std::size_t, std::size_t>> ranges_; // of the places in the cells around

        void find_ranges();
        void add(const Cell& cell) {
            const auto key = key_of(cell);
            const auto begin = std::lower_bound(cells_.keys_.begin(), cells_.keys_.end(), key),
                       end = std::upper_bound(begin, cells_.keys_.end(), key);
            if (begin != end)
                ranges_.emplace_back(begin - cells_.keys_.begin(), end - cells_.keys_.begin());
        }
    };

private:
    static constexpr long long most = 1ll << 20; // cells in a direction; places beyond lie in the last one
    double reach_;
    Coordinates period_, lower_, width_{};
    Cell cells_{}; // in a period
    std::vector<std::uint64_t> keys_;
    std::vector<Coordinates> places_;
    std::vector<int> numbers_;

    Coordinates wrapped(Coordinates x) const {
        for (std::size_t d = 0; d < 3; ++d)
            if (period_[d] > 0)
                x[d] -= period_[d] * std::floor((x[d] - lower_[d]) / period_[d]);
        return x;
    }
    Cell cell_of(const Coordinates& x) const {
        Cell cell;
        for (std::size_t d = 0; d < 3; ++d)
            cell[d] = static_cast<long long>(
                std::floor(std::clamp((x[d] - lower_[d]) / width_[d], -1.0, static_cast<double>(most))));
        return repeated(cell);
    }
    Cell repeated(Cell cell) const {
        for (std::size_t d = 0; d < 3; ++d)
            if (cells_[d] > 0)
                cell[d] = (cell[d] + cells_[d]) % cells_[d];
        return cell;
    }
    static std::uint64_t key_of(const Cell& cell) {
        std::uint64_t key = 0;
        for (std::size_t d = 3; d-- > 0;)
            key = key << 21 | static_cast<std::uint64_t>(cell[d] + 2);
        return key;
    }
};

/// Numbers the bodies that places form: two places nearer than `reach`, m, belong to one body. The i-th number is the
/// body of place i; bodies are numbered in the order of their first places.
std::vector<int> bodies_of(const OutlineColumns& columns, double reach, const OutlineOfScene& scene);

} // namespace imbibe::detail

#if IMBIBE_READS_CODE
#include <imbibe/solver/outline_code.hpp>
#endif
