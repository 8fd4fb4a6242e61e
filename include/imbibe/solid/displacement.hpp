// How far the particles of a total-Lagrangian solid have moved.
#pragma once

#include <imbibe/core/term.hpp>

namespace imbibe {

/// Displacement from the stress-free position, u = x - X, m.
struct DisplacementField : Field<Rank::vector> {
    static constexpr std::string_view name = "displacement", unit = "m";
    static constexpr bool shown = true;
};
inline constexpr DisplacementField displacement{};

/// u_a = x_a - X_a, once per particle. Total-Lagrangian terms are written in it rather than in positions: differences
/// of small numbers keep their digits, and a pair that meets across a periodic border needs no image.
///
/// Source: the definition of the displacement.
struct Displacement {
    using reads = Fields<position, reference_position>;
    using sets = Fields<displacement>;
    static constexpr bool in_packs = true;

    IMBIBE_INLINE constexpr auto operator()(const auto& a) const { return a[position] - a[reference_position]; }
};

} // namespace imbibe
