// The energy that a total-Lagrangian solid stores by its deformation.
#pragma once

#include <imbibe/core/term.hpp>
#include <imbibe/solid/reference_correction.hpp>

namespace imbibe {

/// s V psi(F) of a particle, J, with its stress share s (ReferenceCorrection), its stress-free volume V and the energy
/// density psi of the law; 0 before the first evaluation of its deformation. A reduction of the laws of
/// total-Lagrangian solids.
///
/// Not with the energy of HourglassControl, which is stored in addition.
///
/// Source: that of the law.
/// @tparam Law with `static double stored_energy(const auto& material, const Tensor<double, dim>& F)`, J/m^3
template <class Law>
struct ElasticEnergy {
    using reads = Fields<mass, deformation_gradient, stress_share>;
    using reduces = Sum<StoredEnergy>;

    double operator()(const auto& a) const {
        const auto F = a[deformation_gradient];
        for (int k = 0; k < F.size; ++k)
            if (F[k] != 0)
                return a[stress_share] * a[mass] / a.material.density * Law::stored_energy(a.material, F);
        return 0;
    }
};

} // namespace imbibe
