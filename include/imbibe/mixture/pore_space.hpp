// The space that a skeleton with unresolved pores leaves to a fluid that overlaps it.
#pragma once

#include <imbibe/core/lattice.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/mixture/porous_skeleton.hpp>

#include <string_view>

namespace imbibe {

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

/// sum_b kappa_b v_b W_ab over the same, Pa, with the wetting kappa of PoreSpace.
struct WettingSum : Field<Rank::scalar> {
    static constexpr std::string_view name = "wetting_sum", unit = "Pa";
};
inline constexpr WettingSum wetting_sum{};

/// Coefficients of PoreSpace.
struct PoreSpaceParameters {
    /// p_c, the suction that draws a front of the fluid into dry pores of the stress-free skeleton, Pa: 2 gamma
    /// cos(theta)/r with the surface tension gamma, the contact angle theta and the radius r of the pores. Water in
    /// pores of 0.3 mm: 400.
    double suction = 0;

    /// Throws Error for a number out of range. @param where the coupling in the message
    void check(std::string_view where) const {
        require_not_negative(suction, where, "PoreSpaceParameters::suction", "Pa");
    }
};

/// The numbers that PoreSpace prepares from the skeleton.
struct PreparedPoreSpace {
    double wetting = 0; ///< kappa, Pa
};

/// A_a = sum_b v_b W_ab and B_a = sum_b V_b W_ab, without unit, for a particle a of a fluid and the particles b of a
/// PorousSkeleton, with their solid volumes v and present volumes V: InPores computes the porosity from them. A third
/// sum is sum_b kappa v_b W_ab, in Pa, with kappa = p_c n_0/(1 - n_0), the suction p_c of dry pores and the porosity
/// n_0 of the stress-free skeleton.
///
/// Goes `Into` the fluid that overlaps the skeleton.
///
/// Not for two skeletons that overlap each other.
///
/// Source: Boettcher, Jeske, Westhofen and Bender (2025) for the overlap.
template <class Kernel = WendlandC2>
struct PoreSpace {
    static constexpr bool one_sided = true;
    static constexpr bool overlapping = true; ///< no warning that the two overlap
    using Parameters = PoreSpaceParameters;
    using Prepared = PreparedPoreSpace;
    struct Sum { // a: fluid, b: skeleton
        using reads = Fields<solid_volume, present_volume>;
        using adds = Fields<solid_sum, skeleton_sum, wetting_sum>;
        Prepared prepared{};

        IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
            const auto solid = b[solid_volume] * ab.value(Kernel{});
            return values(solid, b[present_volume] * ab.value(Kernel{}), prepared.wetting * solid);
        }
    };
    using parts = Parts<Sum>;

    /// Computed from the skeleton's material.
    template <int dim>
    static Prepared prepare(const auto& material_a, const auto& material_b, const Lattice<dim>&,
                            const Parameters& parameters) {
        const double n_0 = detail::skeleton_of(material_a, material_b).porosity;
        return {.wetting = parameters.suction * n_0 / (1 - n_0)};
    }
};

} // namespace imbibe
