// The volume of a particle, which the volume-based terms share.
#pragma once

#include <imbibe/core/term.hpp>

namespace imbibe {

/// Volume of a particle, m/rho, m^3 (m^2 in 2D).
struct VolumeField : Field<Rank::scalar> {
    static constexpr std::string_view name = "volume", unit = "m^3";
};
inline constexpr VolumeField volume{};

/// V_a = m_a/rho_a, once per particle. Terms that need volumes list it among their parts; it is computed once for all
/// of them. A phase whose volumes are read only by its neighbours (a wall under `Into<Water, ...>`) takes it as a term
/// of its own.
///
/// A total-Lagrangian solid has its stress-free density, so this is its stress-free volume.
///
/// Not in a phase where another term has it among its parts already.
///
/// Source: Monaghan (1992), m/rho as the volume element of the sums.
struct Volume {
    using reads = Fields<mass, density>;
    using sets = Fields<volume>;
    static constexpr bool in_packs = true;

    IMBIBE_INLINE constexpr auto operator()(const auto& a) const { return a[mass] / a[density]; }
};

} // namespace imbibe
