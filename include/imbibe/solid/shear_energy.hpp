// The energy that a solid with a stress rate stores by shear.
#pragma once

#include <imbibe/core/term.hpp>

namespace imbibe {

/// (m/rho_0) S:S/(4 G) of a particle, J, with the deviatoric stress S. In two dimensions, plane strain, with
/// S_zz = -(S_xx + S_yy). A reduction of the stress rates.
///
/// Not for large strains, where a stress rate has no energy.
///
/// Source: linear elasticity, Landau and Lifshitz (1986), section 4.
struct ShearEnergy {
    using reads = Fields<mass, deviatoric_stress>;
    using reduces = Sum<StoredEnergy>;

    double operator()(const auto& a) const {
        const auto S = full(a[deviatoric_stress]);
        const double out_of_plane = std::remove_cvref_t<decltype(a)>::dimension == 2 ? sq(trace(S)) : 0;
        return a[mass] / a.material.density * (trace(S * S) + out_of_plane) / (4 * a.material.shear_modulus);
    }
};

} // namespace imbibe
