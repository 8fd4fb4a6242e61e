// What the cases with walls to which a liquid sticks include.
#pragma once

#include "case.hpp"

#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/kernels/kernels.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/no_slip.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

namespace validation {

namespace sph = imbibe;

} // namespace validation
