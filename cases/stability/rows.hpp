// What the table of docs/stability_tables.md is made of: cases, each of one composition and one scene.
#pragma once

#include "march.hpp"

#include <ostream>

namespace stability {

/// One cell of the table: how long can steps be?
struct Row {
    std::string part; ///< "Fluids", ...: which table it stands in
    std::string composition, scene;
    double value; ///< of the scene's physical quantity
    std::function<Outcome(const Plan&)> run;
};

/// One physical limit: how far can a quantity be taken at the default CFL number?
struct Frontier {
    std::string composition, scene, quantity;
    double mild, harsh; ///< between them the limit is looked for, evenly in the logarithm
    std::function<Outcome(const Plan&)> run;
    std::function<double(double)> shown = [](double x) { return x; }; ///< what is written of the quantity
};

struct Table {
    std::vector<Row> rows;
    std::vector<Frontier> frontiers;
};

void add_fluids(Table&);
void add_solids(Table&);
void add_coupled(Table&);
void add_limits(Table&);
void add_hard(Table&);
/// What the sums of three kernels make of the gradient of x, for several supports: a table.
void write_gradients(std::ostream&);
/// How far an impact seen from other frames is off, for the coupled compositions: a table.
void write_frames(std::ostream&);

} // namespace stability
