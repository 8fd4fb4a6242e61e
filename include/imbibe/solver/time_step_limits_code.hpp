// The code of time_step_limits.hpp: asks all terms for their limits.
#pragma once

#include <imbibe/solver/reductions.hpp>
#include <imbibe/solver/time_step_limits.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace imbibe::detail {

/// The input of a phase for the limits of its terms.
template <int dim, class Real>
TimeStepInput limit_input(const Neighbourhood<dim, Real>& scene, int phase) {
    const PhaseNumbers numbers = scene.phase(phase).numbers();
    const Motion motion = scene.motion_now(phase);
    return {.support_radius = numbers.support_radius,
            .spacing = numbers.spacing,
            .max_speed = motion.speed,
            .max_acceleration = motion.acceleration,
            .dimension = dim,
            .fastest = motion.fastest};
}
/// The same with the reductions that one of them uses.
template <int dim, class Real>
TimeStepInput with_extremes(TimeStepInput in, const Neighbourhood<dim, Real>& scene, const LimitRow& row) {
    const auto of = [&](int k) {
        return reduced(scene.phase(row.phase), scene.reductions[static_cast<std::size_t>(k)], scene.threads);
    };
    if (row.greatest >= 0)
        in.greatest = of(row.greatest);
    if (row.least >= 0)
        in.least = of(row.least);
    return in;
}

template <int dim, class Real>
std::vector<TimeStepLimit> limits_of(const Neighbourhood<dim, Real>& scene, std::span<const LimitRow> rows,
                                     bool substeps) {
    std::vector<TimeStepInput> inputs;
    for (std::size_t k = 0; k < scene.phases.size(); ++k)
        inputs.push_back(limit_input(scene, static_cast<int>(k)));
    std::vector<TimeStepLimit> limits;
    for (const LimitRow& row : rows) {
        const auto& phase = scene.phase(row.phase);
        if (row.of_substeps != substeps || phase.size() == 0)
            continue;
        const TimeStepInput& own = inputs[static_cast<std::size_t>(row.phase)];
        double seconds = -1;
        std::string where = phase.name;
        switch (row.kind) {
        case LimitKind::of_acceleration:
            if (own.max_acceleration > 0)
                seconds = std::sqrt(own.spacing / own.max_acceleration);
            break;
        case LimitKind::of_advection: {
            const double thrown = phase.row->moves ? std::sqrt(own.spacing * own.max_acceleration) : 0.0;
            if (const double speed = std::max(own.max_speed, thrown); speed > 0)
                seconds = own.spacing / speed;
            break;
        }
        case LimitKind::of_phase:
            seconds = row.seconds(phase.material, phase.material, phase.material, with_extremes(own, scene, row));
            break;
        case LimitKind::of_coupling: {
            const auto& other = scene.phase(row.other);
            if (other.size() == 0 || scene.are_apart(row.phase, row.other))
                continue;
            TimeStepInput in = own;
            in.support_radius = scene.support(row.phase, row.other);
            in.other_spacing = inputs[static_cast<std::size_t>(row.other)].spacing;
            in.other_max_speed = inputs[static_cast<std::size_t>(row.other)].max_speed;
            in.nearest = scene.nearest_of_coupling(row.coupling);
            where = scene.coupling_names[static_cast<std::size_t>(row.coupling)];
            seconds = row.seconds(scene.couplings[static_cast<std::size_t>(row.coupling)], phase.material,
                                  other.material, in);
        }
        }
        if (!(seconds >= 0 && seconds < std::numeric_limits<double>::infinity()))
            continue;
        const auto behind = std::find_if(limits.begin(), limits.end(),
                                         [&](const TimeStepLimit& limit) { return limit.seconds > seconds; });
        limits.insert(behind, {seconds, row.reason, std::move(where)});
    }
    return limits;
}

} // namespace imbibe::detail
