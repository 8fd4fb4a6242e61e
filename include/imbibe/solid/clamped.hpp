// Lets particles of a phase be held in place.
#pragma once

#include <imbibe/core/term.hpp>

namespace imbibe {

/// Gives every particle of a phase a mobility: 1 moves freely, 0 is held (set by `Solver::hold`; a program releases it
/// by setting `scene[phase][mobility]` to 1). A held particle takes part in all sums and its state is advanced; only
/// its velocity and position stay.
///
/// The support of the held particles bears F = - sum_a m_a dv_a/dt over those held, N (N/m in 2D), their weight
/// included. `acceleration` has the value of the last evaluation, which a held particle does not follow.
///
/// A program may move held particles, as the grips of a testing machine or a shaken foot: in every step it writes their
/// positions and their velocities, as for a wall. Not for holding a particle in one direction only.
///
/// Source: the boundary condition of prescribed displacements, zero.
struct Clamped {
    using stores = Fields<mobility>;
};

} // namespace imbibe
