// Creeping flow through an array of cylinders, as in benchmarks/validation, coarse; docs/validation.md has it finer.
#include <benchmarks/validation/cylinders.hpp>
#include <catch_shim.hpp>

namespace cylinders = validation::cylinders;

TEST_CASE("Creeping flow through cylinders has the drag of Sangani and Acrivos", "[validation][fluid]") {
    constexpr int across = 25;
    const double thin = cylinders::flow(across, 0.05).drag, dense = cylinders::flow(across, 0.20).drag;
    const double aslant = cylinders::flow(across, 0.20, 45).drag;
    CAPTURE(thin, dense, aslant, aslant / dense);
    CHECK(thin == Approx(15.56).epsilon(0.03)); // what was asked for with twice as many particles along the cell
    CHECK(dense == Approx(51.53).epsilon(0.03));
    CHECK(aslant == Approx(dense).epsilon(0.01)); // a square array conducts alike in all directions
}
