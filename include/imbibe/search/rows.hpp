// The non-empty rows of cells around a particle's own, also through periodic sides, and the empty stretches along them.
#pragma once

#include <imbibe/search/grid.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace imbibe::search {

/// The number of visible periodic images: -1, 0, +1 period in each direction. Image 0 is the domain itself.
template <int dim>
inline constexpr int image_count = dim == 2 ? 9 : 27;

/// The displacement of image `shift`, in periods along d: 0, 1 or -1.
constexpr int image_step(int shift, int d) {
    for (int k = 0; k < d; ++k)
        shift /= 3;
    return shift % 3 == 2 ? -1 : shift % 3;
}

namespace detail {

/// A row of cells along x.
struct Row {
    std::uint32_t first_cell; ///< where it begins in the cell table
    int y, z;                 ///< -1, 0 or 1: how many rows it is away from the particle's own
    int image;                ///< the periodic image it is seen through
};

/// The non-empty rows around one row, itself included, in the order of the sorted particles, those seen through
/// periodic images last.
template <int dim>
struct IMBIBE_PER_BUILD RowsAround {
    static constexpr std::size_t most = dim == 3 ? 9 : 3; ///< maximum number
    std::array<Row, most> list;
    std::size_t size = 0;
    bool shifted = false; ///< is one of them seen through a periodic image?

    RowsAround() = default;
    /// The rows around row (y, z) of a grid.
    RowsAround(const Grid<dim>& grid, const CellTable& table, int y, int z) {
        // The cell c of direction d and the digit of its periodic image; -1 if there is none.
        const auto around = [&](int d, int c, int& digit) {
            digit = 0;
            const int n = grid.n(d);
            if (c >= 0 && c < n)
                return c;
            if (!grid.wraps(d))
                return -1;
            digit = c < 0 ? 2 : 1;
            c += c < 0 ? n : -n;
            return c >= 0 && c < n ? c : -1;
        };
        const auto n = static_cast<std::uint32_t>(grid.n(0));
        for (int step_z = dim == 3 ? -1 : 0; step_z <= (dim == 3 ? 1 : 0); ++step_z)
            for (int step_y = -1; step_y <= 1; ++step_y) {
                int image_y = 0, image_z = 0, cell_z = 0;
                const int cell_y = around(1, y + step_y, image_y);
                if constexpr (dim == 3)
                    cell_z = around(2, z + step_z, image_z);
                if (cell_y < 0 || cell_z < 0)
                    continue;
                const std::uint32_t row = static_cast<std::uint32_t>(cell_z) * static_cast<std::uint32_t>(grid.n(1)) +
                                          static_cast<std::uint32_t>(cell_y);
                if (table.start(row * n) == table.start(row * n + n))
                    continue;
                const int image = 3 * image_y + 9 * image_z;
                list[size++] = {row * n, step_y, step_z, image};
                shifted = shifted || image != 0;
            }
        if (shifted) // rows without an image come first, and so will their runs
            std::stable_partition(list.begin(), list.begin() + size, [](const Row& row) { return row.image == 0; });
    }

    /// Are the cells from `low` up to, not including, `high` along x empty in all rows, of n cells each?
    bool are_empty(const CellTable& table, int n, int low, int high) const {
        const auto from = static_cast<std::uint32_t>(std::clamp(low, 0, n)),
                   to = static_cast<std::uint32_t>(std::clamp(high, 0, n));
        return std::all_of(list.begin(), list.begin() + size, [&](const Row& row) {
            return table.start(row.first_cell + from) == table.start(row.first_cell + to);
        });
    }
};

/// The stretch along x in which no particle of the rows around is within reach. This holds for most wall particles and
/// the water, and for most of the water and the wall; sorted by cells, they share one check.
template <int dim>
class IMBIBE_PER_BUILD Nobody {
public:
    /// @param support in cells along x
    explicit Nobody(double support) : reach(static_cast<int>(std::ceil(support)) + 2) {}

    /// Resets it for other rows.
    void forget() { end = begin; }

    /// Is certainly no particle within reach of a particle in cell `own`, counted along x?
    bool is_near(const Grid<dim>& grid, const CellTable& table, const RowsAround<dim>& rows, int own) {
        constexpr int asked_at_once = 4; // half a support
        if (own < begin || own >= end) {
            begin = own;
            end = own + asked_at_once;
            const int low = begin - reach, high = end + reach, n = grid.n(0);
            certain = (!grid.wraps(0) || (low >= 0 && high <= n)) && rows.are_empty(table, n, low, high);
        }
        return certain;
    }

private:
    int reach, begin = 0, end = 0; ///< the cells along x that were checked
    bool certain = false;
};

} // namespace detail
} // namespace imbibe::search
