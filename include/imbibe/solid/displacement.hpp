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

/// u_a = x_a - X_a, once per particle. Total-Lagrangian terms are written in it rather than in positions, so that a
/// pair that meets across a periodic border needs no image.
///
/// It is no finer than the positions, which are what is stored: u is a multiple of the last digit of x, about 6e-8 |x|
/// in float and 1e-16 |x| in double, and a step that moves a particle by less than half of that does not move it. The
/// least strain that means anything is that digit over the spacing: 6e-5 in float at 1000 spacings from the origin,
/// which Settings::origin brings nearer. A bar of steel that hangs and is strained by 1e-7 does not stretch in float at
/// all; take double there. Not for fluids, which have no stress-free places.
///
/// Source: the definition of the displacement.
struct Displacement {
    using reads = Fields<position, reference_position>;
    using sets = Fields<displacement>;
    static constexpr bool in_packs = true;

    IMBIBE_INLINE constexpr auto operator()(const auto& a) const { return a[position] - a[reference_position]; }
};

} // namespace imbibe
