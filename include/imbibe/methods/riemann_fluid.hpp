// A fluid with the low-dissipation Riemann scheme.
#pragma once

#include <imbibe/core/method.hpp>
#include <imbibe/fluid/riemann.hpp>
#include <imbibe/wall/riemann_wall.hpp>

namespace imbibe {

/// A weakly compressible fluid by low-dissipation Riemann pairs, and one-sided ones at walls and solids (Zhang, Hu and
/// Adams 2017). An equation of state is listed beside it, and DensityFloor where the fluid has a free surface:
/// `Fluid<LinearState, RiemannFluid<K>, DensityFloor>`.
template <class Kernel = WendlandC2>
struct RiemannFluid : Method<RiemannContinuity<Kernel>, RiemannPressure<Kernel>> {
    /// The terms between such a fluid and a wall or solid.
    template <class Liquid, class Body>
    using coupling = TypeList<Into<Liquid, RiemannWallNormal<Kernel>>, RiemannWallPressure<Kernel>,
                              Into<Liquid, RiemannWallContinuity<Kernel>>>;
};

} // namespace imbibe
