// Notices where two phases between which nothing acts, or two bodies of one total-Lagrangian phase, come so near to
// each other that something should: they would pass through each other.
#pragma once

#include <imbibe/solver/outline.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace imbibe {

/// Two phases, or two bodies of one phase, that have met though nothing acts between them.
struct Meeting {
    std::string first, second;    ///< the phases; of one phase twice the same
    std::vector<double> position; ///< of a particle of the first, m
    double distance;              ///< to the nearest one of the other, m
    double time;                  ///< s
    std::string sentence;         ///< what happened, and the remedy
};

namespace detail {

/// Looks at pairs of phases that no coupling names, and at the bodies of total-Lagrangian phases.
///
/// A fluid meets another phase within the reach that a coupling of the two would have. Solids and walls meet where they
/// are nearer than 0.99 of their mean spacing: their volumes overlap. What touches from the start, within 1.5 spacings,
/// may stay: a solid that is held somewhere beside a wall, and two walls.
class Meetings {
public:
    /// The phases between which nothing acts; to be called again where particles were added.
    void watch(const OutlineOfScene& scene, const std::vector<PhasePair>& pairs) {
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
    /// Two particles may have come nearer to each other by that, m.
    void approach(double way) {
        for (Watched& watched : watched_)
            watched.clear -= way;
    }
    /// Can any have met since the last look?
    bool is_due() const {
        return std::any_of(watched_.begin(), watched_.end(), [](const Watched& w) { return w.is_due(); });
    }
    /// Looks at those that can have met since the last look. Returns those that have.
    std::vector<Meeting> look(const OutlineOfScene& scene, double time) {
        std::vector<Meeting> found;
        for (Watched& watched : watched_) {
            if (!watched.is_due())
                continue;
            const Outline &a = scene[watched.pair.first], &b = scene[watched.pair.second];
            if (a.size() == 0 || b.size() == 0) {
                watched.clear = std::numeric_limits<double>::infinity(); // until some are added
                continue;
            }
            const bool wet = a.kind == Kind::fluid || b.kind == Kind::fluid;
            if (!watched.begun) {
                watched.begun = true;
                if (!wet && ((a.kind == Kind::wall && b.kind == Kind::wall) || holds_any(a) || holds_any(b)))
                    note_touching(watched, a, b, scene);
            }
            const double reach = wet ? watched.pair.reach : 0.99 * 0.5 * (a.spacing + b.spacing);
            const double ahead = a.spacing + b.spacing; // so far it is looked beyond the reach
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

private:
    // By the number that a particle had when it was added. As many may have come and gone as there are numbers.
    using ById = std::unordered_map<std::uint32_t, int>;
    struct Watched {
        PhasePair pair;
        bool begun = false, met = false;
        ById touching{}, touched{}; // those of the first and of the second phase that touch from the start: 1
        ById body{};                // of one phase with itself, the body that each belongs to
        int bodies = 0;
        double clear = 0; // two particles can come nearer by that without being within reach, m

        bool is_due() const { return !met && !(clear > 0) && (pair.first != pair.second || bodies > 1); }
        bool is(const PhasePair& other) const { return pair.first == other.first && pair.second == other.second; }
    };
    struct Nearest {
        int i = -1;
        double distance = std::numeric_limits<double>::infinity();
    };
    std::vector<Watched> watched_;

    bool is_watched(const PhasePair& pair) const {
        return std::any_of(watched_.begin(), watched_.end(), [&](const Watched& w) { return w.is(pair); });
    }
    static void note_bodies(Watched& watched, const Outline& phase, const OutlineOfScene& scene) {
        const std::vector<int> body = bodies_of(phase.at_rest, phase.support_radius, scene);
        watched.clear = 0;
        watched.bodies = body.empty() ? 0 : *std::max_element(body.begin(), body.end()) + 1;
        watched.body.clear();
        for (std::size_t i = 0; i < body.size(); ++i)
            watched.body[phase.ids[i]] = body[i];
    }
    static bool holds_any(const Outline& phase) {
        for (int i = 0; i < phase.mobility.n; ++i)
            if (phase.mobility.at(0, i) == 0)
                return true;
        return false;
    }
    static void note_touching(Watched& watched, const Outline& a, const Outline& b, const OutlineOfScene& scene) {
        watched.touching.clear();
        watched.touched.clear();
        for_each_pair(a, b, 1.5 * 0.5 * (a.spacing + b.spacing), scene, [&](int i, int j, double) {
            watched.touching[a.ids[static_cast<std::size_t>(i)]] = 1;
            watched.touched[b.ids[static_cast<std::size_t>(j)]] = 1;
        });
    }
    static Nearest nearest_pair(const Watched& watched, const Outline& a, const Outline& b, double reach,
                                const OutlineOfScene& scene) {
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
    // Calls f(i, j, distance) for the particles of a and b that are nearer than `reach`, m.
    template <class F>
    static void for_each_pair(const Outline& a, const Outline& b, double reach, const OutlineOfScene& scene,
                              const F& f) {
        const auto those_near = [&](const Outline& one, const OutlineBox& box) {
            std::vector<int> nearby;
            for (int i = 0; i < one.size(); ++i)
                if (box.is_near(one.now.at(i), reach, scene.period))
                    nearby.push_back(i);
            return nearby;
        };
        const std::vector<int> of_a = those_near(a, box_around(b.now));
        if (of_a.empty())
            return;
        OutlineBox box;
        for (const int i : of_a)
            box.include(a.now.at(i));
        const std::vector<int> of_b = those_near(b, box);
        std::vector<Coordinates> places;
        for (const int j : of_b)
            places.push_back(b.now.at(j));
        const PlacesByCell cells(places, reach, scene);
        PlacesByCell::Lookup nearby(cells);
        for (const int i : of_a)
            nearby.for_each_near(a.now.at(i), [&](int k, const Coordinates&, double distance) {
                f(i, of_b[static_cast<std::size_t>(k)], distance);
            });
    }
    static std::string sentence(const Meeting& meeting, const Outline& a, const Outline& b, double reach,
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
                        "through each other. List a coupling in the solver, as in struct Contact : Coupling<", a.name,
                        ", ", b.name, ", KernelRepulsion<>>; one without terms says that they may");
        std::string fluid = a_is_fluid ? a.name : b.name, other = a_is_fluid ? b.name : a.name;
        if (a_is_fluid && b_is_fluid && other < fluid)
            std::swap(fluid, other);
        return text(other, " is within reach of ", fluid, " (", reach, " m) ", where, ", and ", fluid,
                    " does not see it: the two have no coupling, so they pass through each other. List one in the ",
                    "solver, as in struct Sides : Coupling<", fluid, ", ", other,
                    ", ...>; one without terms says that they may");
    }
};

} // namespace detail
} // namespace imbibe
