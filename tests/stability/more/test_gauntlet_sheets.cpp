// Sheets, threads and single particles with corrected gradients. Row 4 of the gauntlet.
#include "margins.hpp"
#include <cases/stability/thin.hpp>

using namespace gauntlet;
using stability::Hookean;

TEST_CASE("Sheets, threads and single particles of a solid are neither torn nor blown up", "[stability]") { // row 4
    for (const double rough : {0.05, 0.2})
        check_preset(stability::thin_solids<Hookean>, rough);
    // a correction that does not give way does not bear a sheet that is a little rough
    const Outcome stubborn =
        stability::thin_solids_with<Hookean>({.value = 0.05}, {.full_above = 1e-5, .none_below = 1e-6});
    INFO(words(stubborn));
    CHECK(!stubborn.stable);
}

TEST_CASE("Threads, pairs and single drops of water with corrected gradients stay finite", "[stability]") { // row 4
    for (const double rough : {0.0, 0.3})
        check_margin(stability::thin_water, rough);
}
