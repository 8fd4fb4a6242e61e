// A fluid that fills a box which is periodic on all sides: its volume cannot change, and it has no surface at which its
// particles find room.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/core/error.hpp>
#include <imbibe/solver/scene_store.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace imbibe::detail {

/// The volume of the box that a phase fills alone, m^dim (m^2 in 2D); 0 where it does not: a side is not periodic, or
/// other phases have particles.
template <int dim, class Real>
double box_of(const SceneStore<dim, Real>& scene, int phase);

/// Changes the rates of the densities so that the sum of m/rho is after a step of dt what it was before, if that is the
/// volume of the box, to a fiftieth (less: there are voids, and surfaces): rate -> f rate + (f - 1) rho/dt, with f the
/// sum after over that before. It is as if all densities were multiplied by f, the same for all, behind the step.
///
/// Sum_a V_a (div v)_a over the neighbours is the rate at which sum_ab V_a V_b W_ab falls. So a continuity equation
/// counts as compression what is disorder of the particles: it rises as a lattice is stirred, all densities by 1 to 3 %
/// within a turn of the flow, and the pressure takes that work from the flow.
/// @param before the densities, kg/m^3, which s need not hold any more
/// @param dt s; nothing is done where it is 0
/// @param box m^dim, or 0
///
/// Source: own.
template <int dim, class Real>
void keep_volume(PhaseStore<dim, Real>& s, const Real* before, double dt, double box, int threads);

/// The greatest speed of the particles of a phase against their mean velocity, m/s.
template <int dim, class Real>
double greatest_relative_speed(const PhaseStore<dim, Real>& s);

/// A sentence if a fluid fills a box that is periodic on all sides, flows in it, and lists nothing that keeps its
/// particles evenly spread, or an empty one. Sound, whose particles stay near where they are, is no flow: what moves
/// faster than a fiftieth of its speed is.
///
/// With a surface particles find room there. Without one they line up along streamlines, voids open between them, and
/// the flow loses energy.
template <int dim, class Real>
std::string warning_of_no_shifting(const SceneStore<dim, Real>& scene, int phase);

} // namespace imbibe::detail

#if IMBIBE_READS_CODE
#include <imbibe/solver/closed_fluid_code.hpp>
#endif
