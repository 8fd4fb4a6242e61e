// The studies of accuracy_cost: one function, and one file, for each scene with a reference.
#pragma once

#include <imbibe/accuracy/study.hpp>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace cost {

namespace sph = imbibe;
namespace accuracy = imbibe::accuracy;
using Rows = std::vector<accuracy::Row>;
using Words = std::vector<std::string>; ///< the choices on an axis

// Each adds its axes to the study and runs it; `quick`: the coarsest resolutions only.
Rows taylor_green(accuracy::Study study, bool quick); ///< vortices that decay, Re = 100
Rows poiseuille(accuracy::Study study, bool quick);   ///< the start of a flow between plates
Rows dam_break(accuracy::Study study, bool quick);    ///< the front of a column that collapses
Rows cylinders(accuracy::Study study, bool quick);    ///< creeping flow through an array of cylinders
Rows plate(accuracy::Study study, bool quick);        ///< a plate that swings
Rows soft_plate(accuracy::Study study, bool quick);   ///< water on a soft plate
Rows sponge(accuracy::Study study, bool quick);       ///< one row of pores of the sponge

/// The compositions that a case compares, which are compiled one by one: a run with each, and what it is called on
/// every axis of words (scheme, kernel, integrator, precision). Not all combinations of these are there.
/// @tparam Result what a run with one of them gives
template <class Result = accuracy::Outcome>
class Compositions {
public:
    using Departures = std::vector<std::pair<std::string, std::string>>; ///< an axis and the choice on it
    using Run = std::function<Result(const accuracy::Choices&)>;

    /// @param first the choice of each axis from which the others depart, @param known the departures, none for the
    /// first, and a run with each
    Compositions(const Departures& first, const std::vector<std::pair<Departures, Run>>& known) : first_(first) {
        for (const auto& [departures, run] : known)
            known_.push_back({departures, with(departures), run});
    }

    /// Adds the axes and, beside departures on one of them, the compositions that depart on several.
    void add_to(accuracy::Study& study) const {
        for (std::size_t axis = 0; axis < first_.size(); ++axis) {
            Words words{first_[axis].second};
            for (const Known& one : known_)
                if (const auto& word = one.words[axis].second;
                    std::find(words.begin(), words.end(), word) == words.end())
                    words.push_back(word);
            study.axis(first_[axis].first, words);
        }
        for (const Known& one : known_)
            if (one.departures.size() > 1)
                study.also(one.departures);
    }
    /// A run with the composition that is chosen. Throws Error if it is not compiled in.
    Result operator()(const accuracy::Choices& choose) const {
        std::string wanted;
        for (const auto& [axis, word] : first_)
            wanted += (wanted.empty() ? "" : ", ") + choose[axis];
        for (const Known& one : known_)
            if (std::all_of(one.words.begin(), one.words.end(),
                            [&](const auto& word) { return choose[word.first] == word.second; }))
                return one.run(choose);
        throw sph::Error("this case is not compiled with " + wanted + " together: add it to its compositions");
    }

private:
    struct Known {
        Departures departures, words; // from the first, and on all axes
        Run run;
    };
    Departures first_;
    std::vector<Known> known_;

    Departures with(const Departures& departures) const {
        Departures all = first_;
        for (const auto& departure : departures) {
            const auto at =
                std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.first == departure.first; });
            sph::require(at != all.end(), "there is no axis '", departure.first, "'");
            at->second = departure.second;
        }
        return all;
    }
};

} // namespace cost
