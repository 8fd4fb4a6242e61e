// The code of meetings.hpp: looks for pairs that have met.
#pragma once

#include <imbibe/solver/meetings.hpp>

namespace imbibe::detail {

IMBIBE_CODE void Meetings::watch(const OutlineOfScene& scene, const std::vector<PhasePair>& pairs) {
    for (Watched& watched : watched_)
        watched.clear = 0;
    for (const PhasePair& pair : pairs)
        if (!pair.coupled && !is_watched(pair))
            watched_.push_back({pair});
    for (int k = 0; k < static_cast<int>(scene.phases.size()); ++k) {
        const Outline& phase = scene[k];
        if (!phase.knows_bodies)
            continue;
        const PhasePair itself{k, k, phase.spacing, false};
        if (!is_watched(itself))
            watched_.push_back({itself});
        note_bodies(*std::find_if(watched_.begin(), watched_.end(), [&](const Watched& w) { return w.is(itself); }),
                    phase, scene);
    }
}

IMBIBE_CODE std::vector<Meeting> Meetings::look(const OutlineOfScene& scene, double time) {
    std::vector<Meeting> found;
    for (Watched& watched : watched_) {
        if (!watched.is_due())
            continue;
        const Outline &a = scene[watched.pair.first], &b = scene[watched.pair.second];
        if (a.size() == 0 || b.size() == 0) {
            watched.clear = std::numeric_limits<double>::infinity(); // until particles are added
            continue;
        }
        const bool wet = a.kind == Kind::fluid || b.kind == Kind::fluid;
        if (!watched.begun) {
            watched.begun = true;
            if (!wet && ((a.kind == Kind::wall && b.kind == Kind::wall) || holds_any(a) || holds_any(b)))
                note_touching(watched, a, b, scene);
        }
        const double reach = wet ? watched.pair.reach : 0.99 * 0.5 * (a.spacing + b.spacing);
        const double ahead = a.spacing + b.spacing; // search distance beyond the reach
        const Nearest nearest = nearest_pair(watched, a, b, reach + ahead, scene);
        watched.clear = std::max(nearest.distance - reach, 0.05 * ahead);
        if (nearest.i < 0)
            watched.clear = ahead;
        if (!(nearest.distance < reach))
            continue;
        watched.met = true;
        Meeting meeting{a.name, b.name, {}, nearest.distance, time, {}};
        for (std::size_t d = 0; d < static_cast<std::size_t>(scene.dim); ++d)
            meeting.position.push_back(a.now.at(d, nearest.i) + scene.origin[d]);
        meeting.sentence = sentence(meeting, a, b, reach, scene.text_of(a.now.at(nearest.i)));
        found.push_back(std::move(meeting));
    }
    return found;
}

IMBIBE_CODE void Meetings::note_bodies(Watched& watched, const Outline& phase, const OutlineOfScene& scene) {
    const std::vector<int> body = bodies_of(phase.at_rest, phase.support_radius, scene);
    watched.clear = 0;
    watched.bodies = body.empty() ? 0 : *std::max_element(body.begin(), body.end()) + 1;
    watched.body.clear();
    for (std::size_t i = 0; i < body.size(); ++i)
        watched.body[phase.ids[i]] = body[i];
}

IMBIBE_CODE void Meetings::note_touching(Watched& watched, const Outline& a, const Outline& b,
                                         const OutlineOfScene& scene) {
    watched.touching.clear();
    watched.touched.clear();
    for_each_pair(a, b, 1.5 * 0.5 * (a.spacing + b.spacing), scene, [&](int i, int j, double) {
        watched.touching[a.ids[static_cast<std::size_t>(i)]] = 1;
        watched.touched[b.ids[static_cast<std::size_t>(j)]] = 1;
    });
}

IMBIBE_CODE Meetings::Nearest Meetings::nearest_pair(const Watched& watched, const Outline& a, const Outline& b,
                                                     double reach, const OutlineOfScene& scene) {
    Nearest nearest;
    const auto of = [](const ById& numbers, const Outline& phase, int i) {
        const auto found = numbers.find(phase.ids[static_cast<std::size_t>(i)]);
        return found == numbers.end() ? 0 : found->second;
    };
    for_each_pair(a, b, reach, scene, [&](int i, int j, double distance) {
        const bool counts = &a == &b ? of(watched.body, a, i) != of(watched.body, a, j)
                                     : of(watched.touching, a, i) == 0 && of(watched.touched, b, j) == 0;
        if (counts && distance < nearest.distance)
            nearest = {i, distance};
    });
    return nearest;
}

IMBIBE_CODE std::string Meetings::sentence(const Meeting& meeting, const Outline& a, const Outline& b, double reach,
                                           const std::string& place) {
    const std::string where =
        text("at ", place, ", time ", meeting.time, " s, where a pair is ", meeting.distance, " m apart");
    if (&a == &b)
        return text("two bodies of ", a.name, " touch ", where, " (the spacing is ", a.spacing,
                    " m). Nothing acts between bodies of one total-Lagrangian phase, so they pass through each ",
                    "other. Make them two phases, with a coupling that has a KernelRepulsion");
    const bool a_is_fluid = a.kind == Kind::fluid, b_is_fluid = b.kind == Kind::fluid;
    if (!a_is_fluid && !b_is_fluid)
        return text(a.name, " and ", b.name, " touch ", where, ", and nothing acts between them: they pass ",
                    "through each other. List a coupling in the solver, as in struct Contact : Coupling<", a.name, ", ",
                    b.name, ", KernelRepulsion<>>; one without terms says that they may");
    std::string fluid = a_is_fluid ? a.name : b.name, other = a_is_fluid ? b.name : a.name;
    if (a_is_fluid && b_is_fluid && other < fluid)
        std::swap(fluid, other);
    return text(other, " is within reach of ", fluid, " (", reach, " m) ", where, ", and ", fluid,
                " does not see it: the two have no coupling, so they pass through each other. List one in the ",
                "solver, as in struct Sides : Coupling<", fluid, ", ", other,
                ", ...>; one without terms says that they may");
}

} // namespace imbibe::detail
