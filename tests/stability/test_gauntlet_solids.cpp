// Hard cases of solids, short. The scenes are those of benchmarks/stability, which bisects how much harder they may be.
#include "margins.hpp"
#include "stability/solids.hpp"

using namespace gauntlet;
using stability::Averaged;
using stability::Hookean;
using stability::Hypoelastic;

TEST_CASE("Bars are stretched and come back", "[stability]") { // row 1
    check_preset(stability::stretched_bar<Hookean>, 0.15);
    check_margin(stability::stretched_bar<Hypoelastic>, 0.1);
}

TEST_CASE("Rubber rings collide and no particles fall on top of each other", "[stability]") { // row 1
    check_margin(stability::colliding_rings<Hypoelastic>, 0.059);
}

TEST_CASE("Beams swing without a zero-energy pattern, nearly incompressible ones too", "[stability]") { // rows 3 and 9
    check_preset(stability::bent_beam<Hookean>, 0.3);
    check_preset(stability::bent_beam<Hookean>, 0.499);
    check_margin(stability::bent_beam<Averaged>, 0.499);
}

TEST_CASE("A column is twisted by a revolution and stays smooth", "[stability]") { // row 9
    check_preset(stability::twisted_column<Hookean>, 0.45);
    check_preset(stability::twisted_column<Hookean>, 0.499);
}

TEST_CASE("A plate spins without losing its angular momentum", "[stability]") { // row 14
    check_preset(stability::spinning_plate<Hookean>);
}

TEST_CASE("Steps of 5 and 20 times the limit of a solid are noticed", "[stability]") { // row 13
    check_noticed(stability::stretched_bar<Hookean>, 0.15);
    check_noticed(stability::bent_beam<Averaged>, 0.499);
}
