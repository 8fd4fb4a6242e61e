// The periodic cell of a porous body: the spacings that fit into it.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/geometry/box.hpp>

#include <algorithm>
#include <cmath>

namespace imbibe::detail {

/// Throws Error unless each side of the cell is a whole number of spacings. @param who the function that asks
inline void require_whole_spacings(const char* who, const Box<3>& cell, double spacing) {
    require_positive(who, "spacing", spacing, "Give the distance between particles in metres.");
    require(cell.bounded(), who, ": the cell must be bounded. Give two corners.");
    for (int k = 0; k < 3; ++k) {
        const double number = cell.size()[k] / spacing;
        require(std::abs(number - std::round(number)) < 1e-3, who, ": side ", "xyz"[k], " of the cell is ", number,
                " spacings of ", spacing, " m long; it must be a whole number of them. Take ",
                cell.size()[k] / std::round(std::max(number, 1.0)), " m.");
    }
}

/// The spacing nearest to 1.5 times this one that divides all sides, m; 0 if none from 1.15 to 2.5 times does.
[[nodiscard]] inline double wider_spacing(const Box<3>& cell, double spacing) {
    double wide = 0;
    const double shortest = cell.size().minCoeff();
    for (double number = 4; number < 0.9 * shortest / spacing; ++number) {
        const double trial = shortest / number;
        const Point<3> cells = cell.size() / trial;
        if ((cells - cells.array().round().matrix()).cwiseAbs().maxCoeff() < 1e-6 &&
            std::abs(trial / spacing - 1.5) < std::abs(wide / spacing - 1.5))
            wide = trial;
    }
    return wide > 1.15 * spacing && wide < 2.5 * spacing ? wide : 0;
}

} // namespace imbibe::detail
