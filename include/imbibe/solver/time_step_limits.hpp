// The limits on a time step: every active term and coupling has its own, listed with their reasons. limit_rows.hpp has
// the table of them.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/solver/neighbourhood.hpp>

#include <span>
#include <string>
#include <vector>

namespace imbibe {

/// A limit on the time step: its length, reason, and phase or coupling.
struct TimeStepLimit {
    double seconds; ///< the longest stable step, s
    /// Its reason, and the phase or coupling.
    std::string reason, where;
};

namespace detail {

/// The limits on the steps of a scene for its present speeds, without the CFL number, shortest first.
/// @param substeps the limits on the short steps of a step, or on the step itself
template <int dim, class Real>
std::vector<TimeStepLimit> limits_of(const Neighbourhood<dim, Real>& scene, std::span<const LimitRow> rows,
                                     bool substeps);

} // namespace detail
} // namespace imbibe

#if IMBIBE_READS_CODE
#include <imbibe/solver/time_step_limits_code.hpp>
#endif
