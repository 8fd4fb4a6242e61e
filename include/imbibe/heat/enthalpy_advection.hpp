// What moving particles with another velocity than the fluid's leaves out of their heat.
#pragma once

#include <imbibe/fluid/volume.hpp>
#include <imbibe/heat/enthalpy.hpp>
#include <imbibe/kernels/wendland.hpp>

namespace imbibe {

/// dh_a/dt = sum_b V_b (delta v_a . grad_a W_ab) (h_b - h_a), in W/kg, with the transport correction delta v of
/// ParticleShifting or StrainShifting: what the enthalpy of the fluid changes by along the way that a particle is moved
/// beside it. Without this a particle takes its heat along to where the fluid does not flow: docs/validation.md,
/// heated-cavity, has what that does to natural convection.
///
/// In a fluid that conducts heat and whose particles are shifted.
///
/// Not where heat must be conserved to rounding: what a particle gains here none of its neighbours loses. Not in
/// couplings.
///
/// Source: as TransportAdvection, of the enthalpy.
template <class Kernel = WendlandC2>
struct EnthalpyAdvection {
    static constexpr bool within_phases = true;
    struct Carry {
        using reads = Fields<volume, enthalpy, transport_correction>;
        using adds = Fields<enthalpy_rate>;

        IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
            return (b[volume] * ab.gradient(Kernel{}) * dot(a[transport_correction], ab.offset)) *
                   (b[enthalpy] - a[enthalpy]);
        }
    };
    using parts = Parts<Volume, Carry>;
};

} // namespace imbibe
