// The heat correction for particles that are moved with another velocity than the fluid's.
#pragma once

#include <imbibe/fluid/volume.hpp>
#include <imbibe/heat/enthalpy.hpp>
#include <imbibe/kernels/wendland.hpp>

namespace imbibe {

/// dh_a/dt = sum_b V_b (delta v_a . grad_a W_ab) (h_b - h_a), in W/kg, with the transport correction delta v of
/// ParticleShifting or StrainShifting: the change of the fluid's enthalpy along the extra displacement of a particle.
/// Without it a shifted particle carries its heat to where the fluid does not flow; docs/validation.md, heated-cavity,
/// has the effect on natural convection.
///
/// For a fluid that conducts heat and whose particles are shifted.
///
/// Not where heat must be conserved to rounding: the gain of a particle here is no neighbour's loss. Not in couplings.
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
