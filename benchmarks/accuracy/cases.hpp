// The studies of accuracy_cost: one function, and one file, for each scene with a reference.
#pragma once

#include <imbibe/accuracy/study.hpp>

#include <string>
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

/// Throws Error: the study has a method that the case does not know.
[[noreturn]] inline void no_such_method(const char* scene, const std::string& method) {
    throw sph::Error(sph::text(scene, ": there is no method '", method, "'"));
}

} // namespace cost
