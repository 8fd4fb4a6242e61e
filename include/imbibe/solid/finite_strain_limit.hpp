// The time step limit of a solid at large strains.
#pragma once

#include <imbibe/solid/deformation_gradient.hpp>
#include <imbibe/solid/first_piola.hpp>

#include <algorithm>

namespace imbibe {

/// (c/c_0)^2, the square of the speed of the fastest elastic wave at the present strain over that of the stress-free
/// solid, without unit.
struct WaveStiffening : Field<Rank::scalar> {
    static constexpr std::string_view name = "wave_stiffening", unit = "1";
};
inline constexpr WaveStiffening wave_stiffening{};

/// A hyperelastic law with the time step limit of its stiffness at the present strain:
/// `FiniteStrainLimit<CompressibleNeoHookean>` in place of `CompressibleNeoHookean`. It is the law's own limit with the
/// wave speed c = c_0 sqrt(s), where s is the greatest `Law::wave_stiffening` of the last step in the phase, at least 1
/// (and 1 before the first step).
///
/// For bodies held or at rest at large strains: squeezed to a half and less, or stretched to the double. A neo-Hookean
/// block with held edges is stable up to 1.9 times the limit of CompressibleNeoHookean undeformed, 0.91 times squeezed
/// to 0.35 of its length both ways, 0.66 times squeezed to 0.25, and 1.9 times this limit at any of these strains
/// (tests/terms/test_finite_strain_limit.cpp).
///
/// Not for small strains, where it changes nothing and costs a number per particle and a pass over all of them in each
/// step. Not for thin bodies: the limit "corrected gradients" does not include it.
///
/// @tparam Law CompressibleNeoHookean, IsochoricNeoHookean, StVenantKirchhoff, VolumetricDeviatoric, or a user's law
/// with `static T wave_stiffening(const auto& material, const Tensor<T, dim>& F)`
///
/// Source: waves of small amplitude in a strained solid are those of its acoustic tensor: Truesdell and Noll (1965).
template <class Law>
struct FiniteStrainLimit : Law {
    struct Stiffening {
        using reads = Fields<deformation_gradient>;
        using sets = Fields<wave_stiffening>;
        static constexpr bool in_packs = true;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            using T = typename std::remove_cvref_t<decltype(a)>::Scalar;
            return T(Law::wave_stiffening(a.material, a[deformation_gradient]));
        }
    };
    using parts = detail::Concat<detail::PartList<Law>, Parts<Stiffening>>;

    struct Stiffest {
        using reads = Fields<wave_stiffening>;
        using reduces = Max<WaveStiffening>;
        double operator()(const auto& a) const { return a[wave_stiffening]; }
    };
    using reductions = detail::Concat<typename detail::ReductionsOf<Law>::type, Parts<Stiffest>>;
    /// The limit described above, s.
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        return detail::elastic_wave_limit(material, in, 1, std::max(in.greatest, 1.0));
    }
};

} // namespace imbibe
