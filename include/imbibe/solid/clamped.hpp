// Lets a phase have particles that are held where they are.
#pragma once

#include <imbibe/core/term.hpp>

namespace imbibe {

/// Gives every particle of a phase a mobility: 1 moves freely, 0 is held (set by `Solver::hold`). A held particle takes
/// part in all sums and has its state advanced, only its velocity and position stay. What pulls at it is an external
/// force.
///
/// Source: the boundary condition of prescribed displacements, zero.
struct Clamped {
    using stores = Fields<mobility>;
};

} // namespace imbibe
