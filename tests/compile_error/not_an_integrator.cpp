// A number in the place of the integrator.
// expect: NotAnIntegrator<int
// expect: the third argument of a solver is no integrator
// expect: give_it_one_such_as_SymplecticEuler
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, int, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
