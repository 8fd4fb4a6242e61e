// The displacement of the particles of a total-Lagrangian solid.
#pragma once

#include <imbibe/core/term.hpp>

namespace imbibe {

/// Displacement from the stress-free position, u = x - X, m.
struct DisplacementField : Field<Rank::vector> {
    static constexpr std::string_view name = "displacement", unit = "m";
    static constexpr bool shown = true;
};
inline constexpr DisplacementField displacement{};

/// u_a = x_a - X_a, once per particle. Total-Lagrangian terms use it instead of positions, so that a pair that meets
/// across a periodic border needs no image.
///
/// Its resolution is that of the stored positions: u is a multiple of the last digit of x, about 6e-8 |x| in float and
/// 1e-16 |x| in double, and a step that moves a particle by less than half of that does not move it. The least
/// meaningful strain is that digit over the spacing: 6e-5 in float at 1000 spacings from the origin; Settings::origin
/// can bring the origin nearer. A hanging bar of steel with a strain of 1e-7 does not stretch in float at all; use
/// double there. Not for fluids, which have no stress-free positions.
///
/// Source: the definition of the displacement.
struct Displacement {
    using reads = Fields<position, reference_position>;
    using sets = Fields<displacement>;
    static constexpr bool in_packs = true;

    IMBIBE_INLINE constexpr auto operator()(const auto& a) const { return a[position] - a[reference_position]; }
};

} // namespace imbibe
