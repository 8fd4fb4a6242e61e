// Tait's equation with an exponent of 0.
// expect: ExponentBelowOne
// expect: the exponent of this equation of state is below 1
// expect: Tait<0>
// expect: give_it_a_whole_number_from_1_on_such_as_7_of_water
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<0>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.step();
}
