// Lets a phase have particles that are held where they are.
#pragma once

#include <imbibe/core/term.hpp>

namespace imbibe {

/// Gives every particle of a phase a mobility: 1 moves freely, 0 is held (set by `Solver::hold`; a program that sets it
/// to 1 by `scene[phase][mobility]` lets go again). A held particle takes part in all sums and has its state advanced,
/// only its velocity and position stay. What pulls at it is an external force.
///
/// What holds the particles bears F = - sum_a m_a dv_a/dt over those held, N (N/m in 2D), their weight included, with
/// `acceleration` as the last evaluation left it: a held particle has one, and does not follow it.
///
/// A program may move them, as the grips of a testing machine or a foot that is shaken: in every step it writes their
/// positions and their velocities, as it does with a wall. Not for holding a particle in one direction only.
///
/// Source: the boundary condition of prescribed displacements, zero.
struct Clamped {
    using stores = Fields<mobility>;
};

} // namespace imbibe
