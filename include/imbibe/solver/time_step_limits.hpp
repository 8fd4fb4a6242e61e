// The limits on a time step: every active term and coupling offers its own, and they are listed with their reasons.
// Which there are is a table (limit_rows.hpp).
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/solver/neighbourhood.hpp>

#include <span>
#include <string>
#include <vector>

namespace imbibe {

/// A limit on the time step: how long, why, and in which phase or coupling.
struct TimeStepLimit {
    double seconds; ///< the longest stable step, s
    /// What it comes from, and the phase or coupling.
    std::string reason, where;
};

namespace detail {

/// The limits on the steps of a scene for its present speeds, without the CFL number, shortest first.
/// @param substeps those on the short steps that a step is made of, or those on the step itself
template <int dim, class Real>
std::vector<TimeStepLimit> limits_of(const Neighbourhood<dim, Real>& scene, std::span<const LimitRow> rows,
                                     bool substeps);

} // namespace detail
} // namespace imbibe

#if IMBIBE_READS_CODE
#include <imbibe/solver/time_step_limits_code.hpp>
#endif
