// The usual elastic solid.
#pragma once

#include <imbibe/core/method.hpp>
#include <imbibe/solid/total_lagrangian.hpp>

namespace imbibe {

/// A total-Lagrangian elastic solid (Ganzenmueller 2015) with hourglass control: `Solid<TotalLagrangianSolid<>>`.
/// Further terms stand beside it: Clamped, TotalLagrangianViscosity, TimeAveragedMotion.
/// @tparam Law the stress: StVenantKirchhoff, CompressibleNeoHookean, IsochoricNeoHookean, VolumetricDeviatoric
template <class Law = StVenantKirchhoff, class Kernel = WendlandC2>
struct TotalLagrangianSolid : Method<ReferenceCorrection<Kernel>, DeformationGradient<Kernel>, Law,
                                     TotalLagrangianForce<Kernel>, HourglassControl<Kernel>> {};

} // namespace imbibe
