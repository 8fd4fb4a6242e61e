// An elastic skeleton with unresolved pores: a solid that a fluid overlaps.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/phase.hpp>
#include <imbibe/fluid/volume.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/solid/elastic_energy.hpp>
#include <imbibe/solid/first_piola.hpp>
#include <imbibe/solid/st_venant_kirchhoff.hpp>

#include <cmath>
#include <string_view>
#include <type_traits>

namespace imbibe {

/// The volume of the grains or struts in a particle of a skeleton, m^3 (m^2 in 2D). It is constant.
struct SolidVolume : Field<Rank::scalar> {
    static constexpr std::string_view name = "solid_volume", unit = "m^3";
};
inline constexpr SolidVolume solid_volume{};

/// The present volume of a particle of a skeleton with its pores, m^3 (m^2 in 2D).
struct PresentVolume : Field<Rank::scalar> {
    static constexpr std::string_view name = "present_volume", unit = "m^3";
};
inline constexpr PresentVolume present_volume{};

/// The share of a skeleton's pores that is filled with fluid, without unit, 0 to 1.
struct Saturation : Field<Rank::scalar> {
    static constexpr std::string_view name = "saturation", unit = "1";
    static constexpr bool shown = true;
};
inline constexpr Saturation saturation{};

/// sum_a V_a W_ab over the particles a of the fluids in the pores, without unit: 1 in full pores.
struct FluidSum : Field<Rank::scalar> {
    static constexpr std::string_view name = "fluid_sum", unit = "1";
};
inline constexpr FluidSum fluid_sum{};

/// sum_b V_b W_ab over the particles of the stress-free skeleton, without unit: about 1 inside, half at its surface.
struct StressFreeSum : Field<Rank::scalar> {
    static constexpr std::string_view name = "stress_free_sum", unit = "1";
};
inline constexpr StressFreeSum stress_free_sum{};

/// The pressure with which the fluid in the pores resists a change of the skeleton's volume, Pa; see PoreContents.
struct PoreStress : Field<Rank::scalar> {
    static constexpr std::string_view name = "pore_stress", unit = "Pa";
};
inline constexpr PoreStress pore_stress{};

/// Coefficients of PorousSkeleton.
struct PorousSkeletonParameters {
    double porosity = required; ///< n_0 of the dry, stress-free skeleton, without unit: a kitchen sponge 0.9, sand 0.4
    double swelling = 0;        ///< e, the strain in each direction of a saturated skeleton, without unit
    double softening = 0;       ///< d, the share of its moduli that a saturated skeleton loses, without unit

    /// Throws Error for a number out of range. @param where the phase in the message
    void check(std::string_view where) const {
        require(porosity > 0 && porosity < 1, where, ": PorousSkeletonParameters::porosity = ", porosity,
                porosity == required ? " (not given)" : "",
                "; it must be above 0 and below 1, a share of the volume (a kitchen sponge 0.9, sand 0.4)");
        require(swelling >= 0 && swelling <= 1, where, ": PorousSkeletonParameters::swelling = ", swelling,
                "; it must be 0 to 1, a strain in each direction (cellulose sponge 0.1 to 0.3)");
        require(softening >= 0 && softening < 1, where, ": PorousSkeletonParameters::softening = ", softening,
                "; it must be at least 0 and below 1, a share of the moduli (cellulose sponge 0.9)");
    }
};

namespace detail {

// A particle with a smaller sum of volumes around it is at the surface of the body, or outside.
inline constexpr double least_inner_sum = 0.95;

// The fluid of a pair, or the particle that is not a fluid.
template <bool fluid, class A, class B>
IMBIBE_INLINE constexpr const auto& one_of(const A& a, const B& b) {
    if constexpr (is_fluid<typename A::Material> == fluid)
        return a;
    else
        return b;
}
// The parameters of the skeleton among two materials.
constexpr const PorousSkeletonParameters& skeleton_of(const auto& material_a, const auto& material_b) {
    if constexpr (is_fluid<std::remove_cvref_t<decltype(material_a)>>)
        return material_b.coefficients.template get<PorousSkeletonParameters>();
    else
        return material_a.coefficients.template get<PorousSkeletonParameters>();
}

// A particle of a skeleton, for its law of stress: without the strain of swelling.
template <class A>
struct Unswollen {
    using Material = typename A::Material;
    using Scalar = typename A::Scalar;
    static constexpr int dimension = A::dimension;
    const A& a;
    const Material& material;
    Scalar per_stretch;

    template <class F>
    IMBIBE_INLINE constexpr auto operator[](F field) const {
        if constexpr (std::is_same_v<F, std::remove_cvref_t<decltype(deformation_gradient)>>)
            return per_stretch * a[deformation_gradient];
        else
            return a[field];
    }
};

} // namespace detail

/// A law of stress for a skeleton and its pores, `TotalLagrangianSolid<PorousSkeleton<StVenantKirchhoff>>`:
///
///     P = (1 - d S) l^(dim-1) P_law(F/l) - q J F^-T, in Pa,    l = 1 + e S,
///
/// with the saturation S = min(1, sum_a V_a W_ab/(0.95 sum_c V_c W_bc)) from the fluid's particles a (PoreContents) and
/// the neighbours c of the particle b in the stress-free skeleton, swelling e, softening d, and the stress q with which
/// the fluid in the pores resists a change of their volume (PorePressure). The material's density is that of the dry
/// skeleton per total volume, (1 - n_0) times that of the grains, and its moduli are those of the dry, drained
/// skeleton.
///
/// PoreSpace computes the porosity from its solid volumes v_a = (1 - n_0) V_a and present volumes J V_a, in m^3, with
/// the stress-free volume V = m/rho: inside it is n = 1 - (1 - n_0)/J. The grains do not change their volume; only the
/// pores swell.
///
/// Not for skeletons with pores some spacings wide: resolve those. Not around VolumetricDeviatoric or
/// FiniteStrainLimit.
///
/// Source: Biot (1941), with incompressible grains; swelling and softening in proportion to the saturation, as
/// Boettcher, Jeske, Westhofen and Bender (2025).
/// @tparam Law StVenantKirchhoff, CompressibleNeoHookean or IsochoricNeoHookean
template <class Law = StVenantKirchhoff, class Kernel = WendlandC2>
struct PorousSkeleton {
    static constexpr bool of_solids = true;
    static constexpr bool porous = true; ///< SeepingFluid's couplings look for it
    static constexpr double greatest_poisson_ratio = Law::greatest_poisson_ratio;
    using Parameters = PorousSkeletonParameters;

    struct Stress {
        using reads = detail::Concat<typename Law::reads, Fields<deformation_gradient, saturation, pore_stress>>;
        using sets = Fields<first_piola_stress>;
        static constexpr bool in_packs = true;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            using A = std::remove_cvref_t<decltype(a)>;
            using T = typename A::Scalar;
            constexpr int dim = A::dimension;
            const T stretch = 1 + parameters.swelling * a[saturation];
            const auto dry = Law{}(detail::Unswollen<A>{a, a.material, 1 / stretch});
            const T stiffness = (1 - parameters.softening * a[saturation]) * power<dim - 1>(stretch);
            return stiffness * dry - a[pore_stress] * transpose(adjugate(a[deformation_gradient]));
        }
    };
    struct Space {
        using reads = Fields<volume, deformation_gradient>;
        using sets = Fields<solid_volume, present_volume>;
        static constexpr bool in_packs = true;
        Parameters parameters{};

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            return values((1 - parameters.porosity) * a[volume], determinant(a[deformation_gradient]) * a[volume]);
        }
    };
    struct Count {
        using neighbourhood = Reference;
        static constexpr bool once = true;
        using reads = Fields<mass>;
        using adds = Fields<stress_free_sum>;

        IMBIBE_INLINE constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
            return b[mass] / b.material.density * ab.value(Kernel{});
        }
    };
    struct Fill {
        using reads = Fields<fluid_sum, stress_free_sum>;
        using sets = Fields<saturation>;
        static constexpr bool in_packs = true;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            return min(a[fluid_sum] / max(detail::least_inner_sum * a[stress_free_sum], 1e-30), 1.0);
        }
    };
    using parts = Parts<Volume, Count, Fill, Stress, Space>;

    /// s V psi of a particle, J: ElasticEnergy of the law, swollen and softened.
    struct Energy {
        using reads = Fields<mass, deformation_gradient, stress_share, saturation>;
        using reduces = Sum<StoredEnergy>;

        double operator()(const auto& a) const {
            const auto F = a[deformation_gradient];
            constexpr int dim = std::remove_cvref_t<decltype(a)>::dimension;
            const auto& of = a.material.coefficients.template get<Parameters>();
            const double stretch = 1 + of.swelling * a[saturation];
            if (!(determinant(F) > 0))
                return 0; // before the first evaluation
            return a[stress_share] * a[mass] / a.material.density * (1 - of.softening * a[saturation]) *
                   power<dim>(stretch) * Law::stored_energy(a.material, (1 / stretch) * F);
        }
    };
    using reductions = Parts<Energy>;

    static constexpr const char* limit_name = Law::limit_name;
    /// The limit of the law, dry, s.
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        return Law::time_step_limit(material, in);
    }
};

} // namespace imbibe
