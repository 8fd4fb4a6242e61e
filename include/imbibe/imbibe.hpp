// imbibe: smoothed particle hydrodynamics of water, elastic solids, and how they push on each other.
// This header brings everything but the presets and the studies of accuracy.
#pragma once

/// @namespace imbibe
/// The library. What begins with a small letter is a function or the constant of a field, all else a type.

/// @namespace imbibe::search
/// The search for neighbours, which can be used on its own.

/// @namespace imbibe::accuracy
/// What accuracy costs in time: studies of cases with a reference.

/// @namespace imbibe::presets
/// Whole compositions with a name.

/// @namespace imbibe::rules
/// The rules that a scene must keep. Their names stand in the compiler's error where one is broken.

#include <imbibe/coupling/kernel_repulsion.hpp>
#include <imbibe/coupling/modified_repulsion.hpp>
#include <imbibe/coupling/surface_normal.hpp>
#include <imbibe/fluid/cleary_viscosity.hpp>
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/corrected_gradients.hpp>
#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/density_floor.hpp>
#include <imbibe/fluid/generalised_newtonian.hpp>
#include <imbibe/fluid/gradient_correction.hpp>
#include <imbibe/fluid/laminar_viscosity.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/fluid/particle_shifting.hpp>
#include <imbibe/fluid/riemann.hpp>
#include <imbibe/fluid/summation_density.hpp>
#include <imbibe/fluid/summation_relaxation.hpp>
#include <imbibe/fluid/symmetric_pressure.hpp>
#include <imbibe/fluid/transport_advection.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/geometry.hpp>
#include <imbibe/heat/boussinesq.hpp>
#include <imbibe/heat/conduction.hpp>
#include <imbibe/heat/enthalpy_advection.hpp>
#include <imbibe/heat/enthalpy_porosity.hpp>
#include <imbibe/heat/frozen_drag.hpp>
#include <imbibe/heat/frozen_stress.hpp>
#include <imbibe/heat/heat_capacity.hpp>
#include <imbibe/heat/heat_flux.hpp>
#include <imbibe/heat/melting.hpp>
#include <imbibe/heat/surface_temperature.hpp>
#include <imbibe/interface/cohesion.hpp>
#include <imbibe/interface/interface_tension.hpp>
#include <imbibe/interface/liquid_pressure.hpp>
#include <imbibe/interface/settle_surface.hpp>
#include <imbibe/kernels/kernels.hpp>
#include <imbibe/methods/capillary_fluid.hpp>
#include <imbibe/methods/cohesive_fluid.hpp>
#include <imbibe/methods/corrected_gradients.hpp>
#include <imbibe/methods/riemann_fluid.hpp>
#include <imbibe/methods/seeping_fluid.hpp>
#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/methods/weakly_compressible.hpp>
#include <imbibe/mixture/darcy_drag.hpp>
#include <imbibe/mixture/fill_pores.hpp>
#include <imbibe/mixture/in_pores.hpp>
#include <imbibe/mixture/pore_heat.hpp>
#include <imbibe/mixture/pore_pressure.hpp>
#include <imbibe/mixture/pore_space.hpp>
#include <imbibe/mixture/porous_skeleton.hpp>
#include <imbibe/monitor/displacement.hpp>
#include <imbibe/monitor/dynamic_relaxation.hpp>
#include <imbibe/monitor/energy.hpp>
#include <imbibe/monitor/guard.hpp>
#include <imbibe/monitor/longest_stable_step.hpp>
#include <imbibe/monitor/narrowest_passage.hpp>
#include <imbibe/monitor/progress.hpp>
#include <imbibe/monitor/surface_height.hpp>
#include <imbibe/monitor/value_at.hpp>
#include <imbibe/monitor/wall_gauge.hpp>
#include <imbibe/output/recover.hpp>
#include <imbibe/output/run.hpp>
#include <imbibe/output/snapshots.hpp>
#include <imbibe/output/table.hpp>
#include <imbibe/search/neighbour_search.hpp>
#include <imbibe/solid/artificial_stress.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solid/corrected_gradients.hpp>
#include <imbibe/solid/hughes_winget.hpp>
#include <imbibe/solid/jaumann_stress.hpp>
#include <imbibe/solid/pairwise_shear.hpp>
#include <imbibe/solid/stress_force.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/solid/velocity_gradient.hpp>
#include <imbibe/solid/volumetric_deviatoric.hpp>
#include <imbibe/solid/xsph.hpp>
#include <imbibe/solver/costs.hpp>
#include <imbibe/solver/describe.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/hydrostatic.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/state/tait.hpp>
#include <imbibe/state/under_pressure.hpp>
#include <imbibe/time/dual_stepping.hpp>
#include <imbibe/time/leapfrog.hpp>
#include <imbibe/time/midpoint_runge_kutta.hpp>
#include <imbibe/time/position_verlet.hpp>
#include <imbibe/time/predictor_corrector.hpp>
#include <imbibe/time/staggered_leapfrog.hpp>
#include <imbibe/time/subcycled.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/version.hpp>
#include <imbibe/wall/corrected_no_slip.hpp>
#include <imbibe/wall/generalised_no_slip.hpp>
#include <imbibe/wall/no_slip.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>
#include <imbibe/wall/reaction_force.hpp>
#include <imbibe/wall/riemann_wall.hpp>
