// What the table of docs/stability.md is made of: cases, each of one composition and one scene.
#pragma once

#include "march.hpp"

#include <cmath>
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

/// The largest value that is stable, of those between `low` and `high`, to 4 %: at first steps of a factor sqrt(2) from
/// `start` until the verdict changes, then halves. `low` or less means that not even `low` is stable (0 is returned),
/// `high` that all are.
template <class IsStable>
double largest_stable(double low, double start, double high, const IsStable& is_stable) {
    double good = 0, bad = 0, at = start;
    const double factor = std::sqrt(2.0);
    if (is_stable(at)) {
        for (good = at; bad == 0; good = bad == 0 ? at : good) {
            if (good >= high * (1 - 1e-9))
                return high;
            at = std::min(good * factor, high);
            if (!is_stable(at))
                bad = at;
        }
    } else {
        for (bad = at; good == 0; bad = good == 0 ? at : bad) {
            if (bad <= low * (1 + 1e-9))
                return 0;
            at = std::max(bad / factor, low);
            if (is_stable(at))
                good = at;
        }
    }
    while (bad / good > 1.04) {
        const double middle = std::sqrt(good * bad);
        (is_stable(middle) ? good : bad) = middle;
    }
    return good;
}

} // namespace stability
