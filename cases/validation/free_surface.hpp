// The water of the cases with a free surface, and what they measure alike.
#pragma once

#include <imbibe/fluid/cleary_viscosity.hpp>
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/particle_shifting.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/kernels/kernels.hpp>
#include <imbibe/monitor/energy.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

namespace validation {

namespace sph = imbibe;

/// Water with the density diffusion of Molteni and Colagrossi, and what else a case adds.
template <class K, class... Extra>
using Water =
    sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::DensityDiffusion<K>, sph::VolumePressure<K>, Extra...>;

/// The sum of f(i) over the particles, in the order of storage.
template <class View, class F>
double particle_sum(const View& view, const F& f) {
    double total = 0;
    for (int i = 0; i < view.size(); ++i)
        total += f(i);
    return total;
}

/// sum_a m_a (x_a v_a - y_a u_a), kg m^2/s.
template <class View>
double angular_momentum(const View& view) {
    const auto x = view[sph::position], v = view[sph::velocity];
    return particle_sum(view, [&](int i) { return view[sph::mass](i) * (x(i, 0) * v(i, 1) - x(i, 1) * v(i, 0)); });
}

} // namespace validation
