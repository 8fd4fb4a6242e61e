// A density that is set, and to whose rate another term adds.
// expect: two terms of one phase set the same field
// expect: SetTwice<imbibe::Density, imbibe::SummationDensity<
// expect: imbibe::VolumeContinuity<
// expect: Water, imbibe::remove_one_of_the_two_terms>
#include "scene.hpp"

#include <imbibe/fluid/summation_density.hpp>

struct Water
    : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::SummationDensity<K>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
