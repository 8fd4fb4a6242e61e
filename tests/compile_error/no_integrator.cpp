// A solver without an integrator.
// expect: the solver has no integrator, but this phase or coupling in its place
// expect: NoIntegrator<Water
// expect: put_an_integrator_such_as_SymplecticEuler_before_the_phases
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Stone : sph::Wall<> {};
using Scene = sph::Solver<2, double, Water, Stone>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
