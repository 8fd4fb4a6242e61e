// The deformation gradient of a total-Lagrangian solid.
#pragma once

#include <imbibe/solid/displacement.hpp>
#include <imbibe/solid/reference_correction.hpp>

namespace imbibe {

/// sum_b V_b (u_b - u_a) (x) grad_a W_ab, without unit: the gradient of the displacement before its correction.
struct RawDisplacementGradient : Field<Rank::tensor> {
    static constexpr std::string_view name = "raw_displacement_gradient", unit = "1";
};
inline constexpr RawDisplacementGradient raw_displacement_gradient{};

/// F_a = 1 + [sum_b V_b (u_b - u_a) (x) grad_a W_ab] L_a, with the displacement u = x - X, the stress-free volumes
/// V = m/rho_0 and the correction L of ReferenceCorrection. Neighbours and kernel are those of the stress-free solid.
///
/// With the full correction this equals sum_b V_b (x_b - x_a) (x) L_a grad_a W_ab, and is exact for every affine
/// motion. Where the correction is not full, an undeformed solid still has F = 1.
///
/// Not for solids that flow or break: the neighbours never change.
///
/// Source: Bonet and Kulasegaram (2002); Vignjevic, Reveles and Campbell (2006).
template <class Kernel = WendlandC2>
struct DeformationGradient {
    using corrected_kernel = Kernel;
    struct Sum {
        using neighbourhood = Reference;
        using reads = Fields<mass, displacement>;
        using adds = Fields<raw_displacement_gradient>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            const auto weight = b[mass] * ab.gradient(Kernel{}) * (1 / b.material.density);
            return outer(weight * (b[displacement] - a[displacement]), ab.offset);
        }
    };
    struct Correct {
        using reads = Fields<raw_displacement_gradient, gradient_correction>;
        using sets = Fields<deformation_gradient>;
        static constexpr bool in_packs = true;

        IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
            using A = std::remove_cvref_t<decltype(a)>;
            return identity<typename A::Scalar, A::dimension>() +
                   a[raw_displacement_gradient] * full(a[gradient_correction]);
        }
    };
    using parts = Parts<Displacement, Sum, Correct>;
};

} // namespace imbibe
