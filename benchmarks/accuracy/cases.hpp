// The studies of accuracy_cost: one function, and one file, for each scene with a reference.
#pragma once

#include <imbibe/accuracy/study.hpp>

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

/// The methods that a case compares, by the names on their axis.
/// @tparam Result what a run with one of them gives
template <class Result = accuracy::Outcome>
class Methods {
public:
    using Run = std::function<Result(const accuracy::Choices&)>;

    Methods(std::string axis, std::vector<std::pair<std::string, Run>> known)
        : axis_(std::move(axis)), known_(std::move(known)) {}

    /// The choices on the axis.
    Words names() const {
        Words names;
        for (const auto& [name, run] : known_)
            names.push_back(name);
        return names;
    }
    /// A run with the method that is chosen. Throws Error if the case does not know it.
    Result operator()(const accuracy::Choices& choose) const {
        for (const auto& [name, run] : known_)
            if (name == choose[axis_])
                return run(choose);
        throw sph::Error(sph::text("there is no ", axis_, " '", choose[axis_], "'"));
    }

private:
    std::string axis_;
    std::vector<std::pair<std::string, Run>> known_;
};

} // namespace cost
