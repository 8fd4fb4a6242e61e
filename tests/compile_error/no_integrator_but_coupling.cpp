// A solver without an integrator, whose first phase is then missing from its coupling: one error, and it names the cause.
// expect: the solver has no integrator, but this phase or coupling in its place
// expect: NoIntegrator<Water
// expect: put_an_integrator_such_as_SymplecticEuler_before_the_phases
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Stone : sph::Wall<> {};
struct Sides : sph::Coupling<Water, Stone, sph::KernelRepulsion<>> {};
using Scene = sph::Solver<2, double, Water, Stone, Sides>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
