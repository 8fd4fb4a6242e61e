// Where the free surface of a fluid is: set by terms that detect it, for other terms.
#pragma once

#include <imbibe/core/term.hpp>

namespace imbibe {

/// 1 for a particle at a free surface, 0 inside.
struct SurfaceIndicator : Field<Rank::scalar> {
    static constexpr std::string_view name = "surface_indicator", unit = "1";
    static constexpr bool shown = true;
};
inline constexpr SurfaceIndicator surface_indicator{};

} // namespace imbibe
