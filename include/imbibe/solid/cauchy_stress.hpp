// The true stress of a hyperelastic solid, for output.
#pragma once

#include <imbibe/solid/first_piola.hpp>

namespace imbibe {

/// Cauchy stress sigma, Pa: force per present area; tension is positive.
struct CauchyStressField : Field<Rank::symmetric_tensor> {
    static constexpr std::string_view name = "cauchy_stress", unit = "Pa";
};
inline constexpr CauchyStressField cauchy_stress{};

/// sigma = P F^T / J, J = det F, in Pa. No other term reads it: list it for output. Not for a solid with a stress rate,
/// whose stress it is already.
///
/// Source: any textbook of continuum mechanics, for instance Holzapfel (2000).
struct CauchyStress {
    using reads = Fields<deformation_gradient, first_piola_stress>;
    using sets = Fields<cauchy_stress>;
    static constexpr bool in_packs = true;

    IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
        const auto F = a[deformation_gradient];
        return symmetric_part(a[first_piola_stress] * transpose(F)) / determinant(F);
    }
};

} // namespace imbibe
