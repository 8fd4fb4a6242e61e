// The space that a skeleton leaves to a fluid that overlaps it, where pores are too small to resolve.
#pragma once

#include <imbibe/core/term.hpp>
#include <imbibe/fluid/volume.hpp>
#include <imbibe/kernels/wendland.hpp>

#include <string_view>
#include <type_traits>

namespace imbibe {

/// The volume of the grains or struts in a particle of a skeleton, m^3 (m^2 in 2D). It does not change.
struct SolidVolume : Field<Rank::scalar> {
    static constexpr std::string_view name = "solid_volume", unit = "m^3";
};
inline constexpr SolidVolume solid_volume{};

/// The volume of a particle of a skeleton with its pores, as it is now, m^3 (m^2 in 2D).
struct PresentVolume : Field<Rank::scalar> {
    static constexpr std::string_view name = "present_volume", unit = "m^3";
};
inline constexpr PresentVolume present_volume{};

/// A = sum_b v_b W_ab over the particles b of skeletons, with their solid volumes v, without unit.
struct SolidSum : Field<Rank::scalar> {
    static constexpr std::string_view name = "solid_sum", unit = "1";
};
inline constexpr SolidSum solid_sum{};

/// B = sum_b V_b W_ab over the same, with their present volumes V, without unit.
struct SkeletonSum : Field<Rank::scalar> {
    static constexpr std::string_view name = "skeleton_sum", unit = "1";
};
inline constexpr SkeletonSum skeleton_sum{};

namespace detail {

// Below this skeleton sum a particle is at the surface of the skeleton, or outside.
inline constexpr double least_inner_sum = 0.95;

// -dn_a/dA_a, and dn_a/dB_a over that: n = 1 - A/max(B, 0.95).
IMBIBE_INLINE constexpr auto per_solid_sum(const auto& fluid) {
    return 1 / max(fluid[skeleton_sum], least_inner_sum);
}
IMBIBE_INLINE constexpr auto inner_solid_share(const auto& fluid) {
    using T = std::remove_cvref_t<decltype(fluid[skeleton_sum])>;
    return select(fluid[skeleton_sum] > T(least_inner_sum), 1 - fluid[porosity], T(0));
}

} // namespace detail

/// n_a = 1 - A_a/max(B_a, 0.95), A_a = sum_b v_b W_ab, B_a = sum_b V_b W_ab, without unit, for a particle a of a fluid
/// and the particles b of a PorousSkeleton, with their solid volumes v and present volumes V.
///
/// Goes `Into` the fluid that overlaps the skeleton, whose state is InPores. In a skeleton that is the same everywhere n
/// is the same everywhere, wherever the particles of the two lie: all of them have the same v/V. At its surface n rises
/// to 1 over a support radius.
///
/// Not for two skeletons that overlap each other.
///
/// Source: Boettcher, Jeske, Westhofen and Bender (2025) for the overlap; the quotient, Shepard (1968).
template <class Kernel = WendlandC2>
struct PoreSpace {
    static constexpr bool one_sided = true;
    struct Sum { // a: fluid, b: skeleton
        using reads = Fields<solid_volume, present_volume>;
        using adds = Fields<solid_sum, skeleton_sum>;

        IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
            const auto weight = ab.value(Kernel{});
            return values(b[solid_volume] * weight, b[present_volume] * weight);
        }
    };
    struct Set {
        using reads = Fields<solid_sum, skeleton_sum>;
        using sets = Fields<porosity>;
        static constexpr bool in_packs = true;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            return 1 - a[solid_sum] * detail::per_solid_sum(a);
        }
    };
    using parts = Parts<Sum, Set>;
};

} // namespace imbibe
