// A weakly compressible fluid whose slow flow is not disturbed by a high pressure.
#pragma once

#include <imbibe/core/method.hpp>
#include <imbibe/fluid/corrected_gradients.hpp>
#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/density_floor.hpp>
#include <imbibe/fluid/strain_shifting.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

#include <type_traits>

namespace imbibe {

/// WeaklyCompressible with corrected gradients inside the fluid and particle shifting in shear: for slow flow under a
/// high pressure, where WeaklyCompressible resists shear like a solid of up to 0.07 p, or is unstable. An equation of
/// state and a viscosity are listed beside it.
///
/// For walls and solids the fluid's own correction is used, and their particles count in it, as those of another such
/// fluid do.
template <class Kernel = WendlandC2>
struct CorrectedGradients : Method<InnerCorrection<Kernel>, CorrectedContinuity<Kernel>, DensityDiffusion<Kernel>,
                                   DensityFloor, CorrectedPressure<Kernel>, StrainShifting<Kernel>> {
    /// The terms between such a fluid and a wall or solid, or between two such fluids.
    template <class Liquid, class Other>
    using coupling = std::conditional_t<
        detail::is_fluid<Other>,
        TypeList<CorrectedPressure<Kernel>, CorrectionNeighbours<Kernel>, CorrectedContinuity<Kernel>,
                 ConcentrationNeighbours<Kernel>>,
        TypeList<Into<Other, PressureExtrapolation<Kernel>>, CorrectedPressure<Kernel>,
                 Into<Liquid, CorrectionNeighbours<Kernel>>, Into<Liquid, CorrectedContinuity<Kernel>>,
                 Into<Liquid, ConcentrationNeighbours<Kernel>>>>;
};

} // namespace imbibe
