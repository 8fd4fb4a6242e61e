// A fluid that fills a box that is periodic on all sides: its volume cannot change, and it has no free surface.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/core/error.hpp>
#include <imbibe/solver/scene_store.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace imbibe::detail {

/// The volume of the box that a phase fills alone, m^dim (m^2 in 2D); 0 if a side is not periodic, or other phases have
/// particles.
template <int dim, class Real>
double box_of(const SceneStore<dim, Real>& scene, int phase);

/// Changes the density rates so that a step of dt leaves the sum of m/rho unchanged, if that equals the volume of the
/// box to a fiftieth (if it is less, there are voids and surfaces): rate -> f rate + (f - 1) rho/dt, with f the sum
/// after the step over that before. This multiplies all densities after the step by the same f.
///
/// Sum_a V_a (div v)_a over the neighbours is the rate at which sum_ab V_a V_b W_ab falls. So a continuity equation
/// counts the disorder of the particles as compression: as a lattice is stirred, all densities rise by 1 to 3 % within
/// a turn of the flow, and the pressure takes that work from the flow.
/// @param before the densities, kg/m^3, which s need not hold any more
/// @param dt s; if 0, nothing is done
/// @param box m^dim, or 0
///
/// Source: own.
template <int dim, class Real>
void keep_volume(PhaseStore<dim, Real>& s, const Real* before, double dt, double box, int threads);

/// The greatest speed of the particles of a phase relative to their mean velocity, m/s.
template <int dim, class Real>
double greatest_relative_speed(const PhaseStore<dim, Real>& s);

/// A sentence if a fluid fills a box that is periodic on all sides, flows in it, and lists nothing that keeps its
/// particles evenly spread; else empty. Speeds below a fiftieth of the sound speed do not count as flow: in sound waves
/// particles stay near their positions.
///
/// Without a free surface particles line up along streamlines, voids open between them, and the flow loses energy.
template <int dim, class Real>
std::string warning_of_no_shifting(const SceneStore<dim, Real>& scene, int phase);

} // namespace imbibe::detail

#if IMBIBE_READS_CODE
#include <imbibe/solver/closed_fluid_code.hpp>
#endif
