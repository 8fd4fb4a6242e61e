// The fluid that is measured in every way: as a program of the library runs it, and with a continuity equation that
// does not feed back into the step, so that the schedule finds room for all pair parts in one sweep.
#pragma once

#include <imbibe/core/phase.hpp>
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/symmetric_pressure.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/state/tait.hpp>

namespace imbibe::bench {

/// What the continuity equation gives, kept aside, kg/m^3/s.
struct DensityChange : Field<Rank::scalar> {
    static constexpr std::string_view name = "density_change", unit = "kg/m^3/s";
};
inline constexpr DensityChange density_change{};

/// The continuity equation, its result kept aside: the density stays, so the pressure need not wait for it.
template <class Kernel>
struct ContinuityAside {
    using reads = Fields<mass, velocity>;
    using adds = Fields<density_change>;

    IMBIBE_INLINE constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        return Continuity<Kernel>{}(a, b, ab);
    }
};

/// Two sweeps a step: the density rate, then, with the pressure of the new density, the forces.
struct Water : Fluid<Tait<7>, Continuity<WendlandC2>, SymmetricPressure<WendlandC2>, MonaghanViscosity<WendlandC2>> {};

/// The same pair parts in one sweep.
struct WaterInOneSweep
    : Fluid<Tait<7>, ContinuityAside<WendlandC2>, SymmetricPressure<WendlandC2>, MonaghanViscosity<WendlandC2>> {};

/// Its numbers.
template <class Phase>
Phase water() {
    return Phase{{.density = 1000, .sound_speed = 30}};
}

} // namespace imbibe::bench
