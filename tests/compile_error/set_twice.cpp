// Two equations of state.
// expect: two terms of one phase set the same field
// expect: SetTwice<imbibe::Pressure, imbibe::
// expect: imbibe::LinearState
// expect: imbibe::Tait<
// expect: Water, imbibe::remove_one_of_the_two_terms>
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::LinearState, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
