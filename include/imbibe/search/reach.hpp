// The range of cells that the support of particles covers in the rows around them, for several particles at a time, in
// packs.
#pragma once

#include <imbibe/core/vector.hpp>
#include <imbibe/search/rows.hpp>

#include <functional>

namespace imbibe::search::detail {

/// Some particles as the grid sees them. Lengths are in cells along x.
template <int dim>
struct IMBIBE_PER_BUILD PlacesInCells {
    static constexpr std::size_t most = 64;    ///< maximum number
    static constexpr std::size_t padding = 16; ///< packs run on into it; its values do not matter
    std::int32_t cell[static_cast<std::size_t>(dim)][most + padding]{}; ///< the own cell by direction
    float x[most + padding]{};                                          ///< position in that along x, from 0 to 1
    float below[2][most + padding]{}; ///< the squared distance to the rows below along y and z
    float above[2][most + padding]{}; ///< that to the rows above

    /// Takes the particles at place[d][k], k < n, m.
    template <class Place>
    void take(const Grid<dim>& grid, const Place& place, std::size_t n) {
        for (int d = 0; d < dim; ++d) {
            const double lower = grid.lower(d), inverse = 1 / grid.width(d);
            const double width = std::min(grid.width(d) / grid.width(0), 1e9); // squared it is not infinite in float
            const auto& from = place[static_cast<std::size_t>(d)];
            const auto take_along = [&](const auto& fold) {
                for (std::size_t k = 0; k < n; ++k) {
                    const double at = fold((static_cast<double>(from[k]) - lower) * inverse), whole = std::floor(at);
                    const double inside = at - whole;
                    cell[d][k] = static_cast<std::int32_t>(whole);
                    if (d == 0) {
                        x[k] = static_cast<float>(inside);
                    } else {
                        below[d - 1][k] = static_cast<float>(sq(inside * width));
                        above[d - 1][k] = static_cast<float>(sq((1 - inside) * width));
                    }
                }
            };
            if (grid.is_folded(d)) [[unlikely]]
                take_along([&](double at) { return grid.fold(d, at); });
            else
                take_along(std::identity{});
        }
    }
};

/// The first and the last place within reach along x in a row, in cells along x from the beginning of the own cell. In
/// float: the numbers are small, and the slack covers rounding.
template <class T, int dim>
class IMBIBE_PER_BUILD Reach {
public:
    static constexpr int before = 64; ///< added, so that truncation rounds down
    T low;                            ///< with `before`
    T high;                           ///< with `before`; 0 if the row is out of reach, which is below `low`

    /// @param support in cells along x
    IMBIBE_INLINE Reach(const PlacesInCells<dim>& places, std::size_t k, const Row& row, double support) {
        constexpr float slack = 1e-4f;
        T rest(static_cast<float>(sq(support) * (1 + 1e-5)));
        if (row.y != 0)
            rest -= T::load((row.y < 0 ? places.below : places.above)[0] + k);
        if (row.z != 0)
            rest -= T::load((row.z < 0 ? places.below : places.above)[1] + k);
        const T half = sqrt(positive_part(rest)), own = T::load(places.x + k);
        low = own + T(before - slack) - half;
        high = select(rest < T(0), T(0), own + T(before + 1 + slack) + half);
    }
};

/// The cells that particles [begin, end) of `places` reach in each of several rows: from[r][k] up to, not including,
/// to[r][k], of the cell table. The particles share their rows, which have n cells.
template <int dim>
struct IMBIBE_PER_BUILD CellsInReach {
    static constexpr std::size_t room = PlacesInCells<dim>::most + PlacesInCells<dim>::padding;
    std::uint32_t from[RowsAround<dim>::most][room], to[RowsAround<dim>::most][room];

    void find(const PlacesInCells<dim>& places, std::size_t begin, std::size_t end, const RowsAround<dim>& rows, int n,
              double support) {
        using T = Pack<float, native_width<float>>;
        constexpr auto width = static_cast<std::size_t>(T::size);
        static_assert(width <= PlacesInCells<dim>::padding);
        for (std::size_t r = 0; r < rows.size; ++r) {
            const Row row = rows.list[r];
            for (std::size_t k = begin; k < end; k += width) {
                const Reach<T, dim> reach(places, k, row, support);
                std::int32_t low[width], high[width];
                truncate(reach.low, low);
                truncate(reach.high, high);
                for (std::size_t lane = 0; lane < width; ++lane) {
                    const std::int32_t own = places.cell[0][k + lane] - reach.before;
                    const std::int32_t first = std::min(std::max(own + low[lane], 0), n);
                    const std::int32_t last = std::min(std::max(own + high[lane], first), n);
                    from[r][k + lane] = row.first_cell + static_cast<std::uint32_t>(first);
                    to[r][k + lane] = row.first_cell + static_cast<std::uint32_t>(last);
                }
            }
        }
    }
};

} // namespace imbibe::search::detail
