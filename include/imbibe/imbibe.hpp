// imbibe: smoothed particle hydrodynamics of water, elastic solids, and how they push on each other.
// This header brings everything but the presets.
#pragma once

#include <imbibe/coupling/kernel_repulsion.hpp>
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/density_floor.hpp>
#include <imbibe/fluid/laminar_viscosity.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/fluid/symmetric_pressure.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/geometry.hpp>
#include <imbibe/kernels/kernels.hpp>
#include <imbibe/monitor/displacement.hpp>
#include <imbibe/monitor/energy.hpp>
#include <imbibe/monitor/progress.hpp>
#include <imbibe/output/snapshots.hpp>
#include <imbibe/output/table.hpp>
#include <imbibe/solid/artificial_stress.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solid/hughes_winget.hpp>
#include <imbibe/solid/jaumann_stress.hpp>
#include <imbibe/solid/stress_force.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/solid/velocity_gradient.hpp>
#include <imbibe/solid/xsph.hpp>
#include <imbibe/solver/describe.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/state/tait.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/version.hpp>
#include <imbibe/wall/no_slip.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>
