// The momentum correction for particles that are moved with another velocity than the fluid's.
#pragma once

#include <imbibe/core/term.hpp>
#include <imbibe/kernels/wendland.hpp>

namespace imbibe {

/// dv_a/dt = sum_b m_b/rho_b (delta v_a . grad_a W_ab) (v_b - v_a), in m/s^2, with the transport correction delta v of
/// ParticleShifting: (delta v . grad) v, the change of the fluid's velocity along the extra displacement of a particle.
/// Without this a shifted particle takes its velocity along. (XsphTransport sets the same field; this combination is
/// untested.)
///
/// For flows with vortices and shear layers whose particles are shifted by much: with a `strength` of 4 it halves the
/// error of the velocity in a Taylor-Green vortex at Re = 1000, with the default of 2 it takes a tenth of it away, at
/// Re = 100 nothing; a cavity that its lid drives at Re = 1000 is 1.6 to 2.8 % too slow with it, with corrected
/// gradients, and 2.7 to 3.7 % without (docs/validation.md). Its own gradients need no correction: with it the error is
/// the same to a tenth.
///
/// Not in couplings: counting the wall's velocity changes little, and a density that follows a continuity equation
/// drifts, because particles that are shifted off the wall make the fluid flow towards it. Not without viscosity, and
/// not where momentum must be conserved exactly. It costs a whole sweep, so not where particles are hardly shifted. The
/// density is left alone: sound restores its change along the extra displacement. Long steps add energy with it as
/// without it (SymplecticEuler).
///
/// Source: the convective term of Oger et al. (2016) and of Sun et al. (2019), as it is for particles of constant mass.
/// The stress rho v (x) delta v of Adami, Hu and Adams (2013) in its place conserves momentum, but counts v div(rho
/// delta v) besides, and makes that vortex worse.
template <class Kernel = WendlandC2>
struct TransportAdvection {
    using reads = Fields<mass, density, velocity, transport_correction>;
    using adds = Fields<acceleration>;

    IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        const auto towards = dot(a[transport_correction], ab.offset);
        return (b[mass] / b[density] * ab.gradient(Kernel{}) * towards) * (b[velocity] - a[velocity]);
    }
};

} // namespace imbibe
