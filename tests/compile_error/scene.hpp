// What the programs of this folder have in common. Less than imbibe.hpp, so that they compile faster.
#pragma once

#include <imbibe/coupling/kernel_repulsion.hpp>
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/symmetric_pressure.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/state/tait.hpp>
#include <imbibe/time/symplectic_euler.hpp>

namespace sph = imbibe;
using K = sph::WendlandC2;
