// The code of scene_watch.hpp: looks at a scene.
#pragma once

#include <imbibe/solver/scene_watch.hpp>

namespace imbibe::detail {

IMBIBE_CODE bool knows_bodies(const SceneTable& table, int phase) {
    bool reference = false, current = false;
    for (const LinkRow& row : table.links)
        if (row.a == phase && row.b == phase)
            (row.reference ? reference : current) = true;
    return reference && !current;
}

IMBIBE_CODE bool are_coupled(const SceneTable& table, int a, int b) {
    return std::any_of(table.couplings.begin(), table.couplings.end(), [&](const CouplingRow& row) {
        return (row.first == a && row.second == b) || (row.first == b && row.second == a);
    });
}

template <int dim, class Real>
OutlineOfScene outline_of(const SceneStore<dim, Real>& scene, const Origin<dim>& origin) {
    OutlineOfScene outline;
    outline.dim = dim;
    outline.threads = scene.threads;
    for (std::size_t d = 0; d < dim; ++d) {
        outline.origin[d] = origin[d];
        outline.lower[d] = scene.periodic.lower[d];
        outline.period[d] = scene.periodic.length[d];
    }
    for (std::size_t k = 0; k < scene.phases.size(); ++k) {
        const auto& s = scene.phases[k];
        const PhaseRow& row = *s.row;
        const auto columns_from = [&](int first, std::size_t count) {
            OutlineColumns columns;
            columns.n = s.size();
            columns.in_float = sizeof(Real) == sizeof(float);
            for (std::size_t d = 0; d < count; ++d)
                columns.x[d] = s.column(first + static_cast<int>(d));
            return columns;
        };
        const PhaseNumbers numbers = s.numbers();
        Outline one;
        one.name = s.name;
        one.kind = row.fluid ? Kind::fluid : row.moves ? Kind::solid : Kind::wall;
        one.spacing = numbers.spacing;
        one.support_radius = numbers.support_radius;
        one.now = columns_from(row.position, dim);
        one.at_rest = row.keeps_reference() ? columns_from(row.reference_position, dim) : one.now;
        one.ids = s.ids.data();
        one.ever_added = s.ever_added();
        one.knows_bodies = knows_bodies(scene.table, static_cast<int>(k));
        if (row.mobility >= 0)
            one.mobility = columns_from(row.mobility, 1);
        outline.phases.push_back(std::move(one));
    }
    return outline;
}

template <int dim, class Real>
std::vector<PhasePair> pairs_of_phases(const SceneStore<dim, Real>& scene) {
    std::vector<PhasePair> pairs;
    const int count = static_cast<int>(scene.phases.size());
    for (int a = 0; a < count; ++a)
        for (int b = a + 1; b < count; ++b)
            pairs.push_back({a, b, scene.support(a, b), are_coupled(scene.table, a, b)});
    return pairs;
}

template <int dim, class Real>
void SceneWatch::look_at_added(const Neighbourhood<dim, Real>& scene, const Origin<dim>& origin, double time,
                               Warnings& warnings) {
    const OutlineOfScene outline = outline_of(scene, origin);
    crowding_.resize(outline.phases.size());
    for (std::size_t k = 0; k < outline.phases.size(); ++k) {
        auto& [looked_at, found] = crowding_[k];
        const Outline& phase = outline.phases[k];
        if (!found && phase.ever_added > looked_at) {
            const std::string sentence = warning_of_crowding(phase, looked_at, outline);
            found = !sentence.empty(); // a source would repeat it at every step
            warnings.note(sentence);
        }
        looked_at = phase.ever_added;
    }
    if (anyone_may_meet(scene.table)) {
        meetings_.watch(outline, pairs_of_phases(scene));
        note_meetings(outline, time, warnings);
    }
}

template <int dim, class Real>
void SceneWatch::start_anew(const Neighbourhood<dim, Real>& scene, const Origin<dim>& origin, double time,
                            Warnings& warnings) {
    meetings_ = {};
    met_.clear();
    crowding_.resize(scene.phases.size());
    for (std::size_t k = 0; k < crowding_.size(); ++k)
        crowding_[k].first = scene.phases[k].ever_added();
    look_at_added(scene, origin, time, warnings);
}

template <int dim, class Real>
void SceneWatch::look_after_step(const Neighbourhood<dim, Real>& scene, const Origin<dim>& origin, double time,
                                 double seconds, Warnings& warnings) {
    since_look_ += seconds;
    if (++steps_ % 10 != 0 || !anyone_may_meet(scene.table))
        return;
    meetings_.approach(3 * greatest_speed(scene) * since_look_); // both move, perhaps faster in between
    since_look_ = 0;
    if (meetings_.is_due())
        note_meetings(outline_of(scene, origin), time, warnings);
}

IMBIBE_CODE bool SceneWatch::anyone_may_meet(const SceneTable& table) {
    const int count = static_cast<int>(table.phases.size());
    for (int a = 0; a < count; ++a) {
        if (knows_bodies(table, a))
            return true;
        for (int b = a + 1; b < count; ++b)
            if (!are_coupled(table, a, b))
                return true;
    }
    return false;
}

IMBIBE_CODE void SceneWatch::note_meetings(const OutlineOfScene& outline, double time, Warnings& warnings) {
    for (Meeting& meeting : meetings_.look(outline, time)) {
        warnings.note(meeting.sentence);
        met_.push_back(std::move(meeting));
    }
}

template <int dim, class Real>
double SceneWatch::greatest_speed(const Neighbourhood<dim, Real>& scene) {
    double most = 0;
    for (std::size_t k = 0; k < scene.phases.size(); ++k)
        if (scene.phases[k].size() > 0)
            most = std::max(most, scene.phases[k].row->velocity >= 0 ? scene.motion_now(static_cast<int>(k)).fastest
                                                                     : std::numeric_limits<double>::infinity());
    return most;
}

} // namespace imbibe::detail
