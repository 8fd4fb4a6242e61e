// Detects when two phases without interaction, or two bodies of one total-Lagrangian phase, come so near that they
// would pass through each other.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/solver/outline.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace imbibe {

/// Two phases, or two bodies of one phase, that have met although nothing acts between them.
struct Meeting {
    std::string first, second;    ///< the phases; the same twice for bodies of one
    std::vector<double> position; ///< of a particle of the first, m
    double distance;              ///< to the nearest one of the other, m
    double time;                  ///< s
    std::string sentence;         ///< what happened, and a remedy
};

namespace detail {

/// Checks pairs of phases that no coupling names, and the bodies of total-Lagrangian phases.
///
/// A fluid meets another phase within the reach that a coupling of the two would have. Solids and walls meet when they
/// are nearer than 0.99 of their mean spacing: their volumes overlap. Particles that touch from the start, within 1.5
/// spacings, may stay: a solid that is held beside a wall, or two walls.
class Meetings {
public:
    /// Sets the phases between which nothing acts; call it again when particles were added.
    void watch(const OutlineOfScene& scene, const std::vector<PhasePair>& pairs);
    /// Records that two particles may have approached by this distance, m.
    void approach(double way) {
        for (Watched& watched : watched_)
            watched.clear -= way;
    }
    /// May any have met since the last look?
    bool is_due() const {
        return std::any_of(watched_.begin(), watched_.end(), [](const Watched& w) { return w.is_due(); });
    }
    /// Checks those that may have met since the last look. Returns those that have.
    std::vector<Meeting> look(const OutlineOfScene& scene, double time);

private:
    // By the number a particle had when it was added, in a map because most numbers may be gone.
    using ById = std::unordered_map<std::uint32_t, int>;
    struct Watched {
        PhasePair pair;
        bool begun = false, met = false;
        ById touching{}, touched{}; // those of the two phases that touch from the start: 1
        ById body{};                // for one phase with itself, the body of each particle
        int bodies = 0;
        double clear = 0; // how far two particles may approach without being within reach, m

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
    static void note_bodies(Watched& watched, const Outline& phase, const OutlineOfScene& scene);
    static bool holds_any(const Outline& phase) {
        for (int i = 0; i < phase.mobility.n; ++i)
            if (phase.mobility.at(0, i) == 0)
                return true;
        return false;
    }
    static void note_touching(Watched& watched, const Outline& a, const Outline& b, const OutlineOfScene& scene);
    static Nearest nearest_pair(const Watched& watched, const Outline& a, const Outline& b, double reach,
                                const OutlineOfScene& scene);
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
                                const std::string& place);
};

} // namespace detail
} // namespace imbibe

#if IMBIBE_READS_CODE
#include <imbibe/solver/meetings_code.hpp>
#endif
