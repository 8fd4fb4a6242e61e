// The usual weakly compressible fluid.
#pragma once

#include <imbibe/core/method.hpp>
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/density_floor.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

#include <type_traits>

namespace imbibe {

/// A weakly compressible fluid with a free surface: continuity and pressure between volumes (Colagrossi and Landrini
/// 2003), density diffusion (Molteni and Colagrossi 2009) and a floor under the density. An equation of state and a
/// viscosity are listed beside it: `Fluid<Tait<7>, WeaklyCompressible<K>, MonaghanViscosity<K>>`.
///
/// The fluid's pressure is continued to walls and solids (Adami, Hu and Adams 2012), which then push on it, and their
/// volumes count in its continuity.
template <class Kernel = WendlandC2>
struct WeaklyCompressible
    : Method<VolumeContinuity<Kernel>, DensityDiffusion<Kernel>, DensityFloor, VolumePressure<Kernel>> {
    /// What acts between such a fluid and a wall or solid, or between two such fluids.
    template <class Liquid, class Other>
    using coupling =
        std::conditional_t<detail::is_fluid<Other>, TypeList<VolumePressure<Kernel>, VolumeContinuity<Kernel>>,
                           TypeList<Into<Other, PressureExtrapolation<Kernel>>, VolumePressure<Kernel>,
                                    Into<Liquid, VolumeContinuity<Kernel>>>>;
};

} // namespace imbibe
