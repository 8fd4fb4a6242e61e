// A solver without an integrator.
// expect: the solver has no integrator, but this phase or coupling in its place
// expect: NoIntegrator<Water
// expect: put_an_integrator_such_as_SymplecticEuler_before_the_phases
#include "scene.hpp"

#include <imbibe/monitor/guard.hpp>
#include <imbibe/output/snapshots.hpp>
#include <imbibe/solver/describe.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Stone : sph::Wall<> {};
using Scene = sph::Solver<2, double, Water, Stone>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.add(Water{{.density = 1000, .sound_speed = 10}}, {{0, 0}}, 0.1);
    describe(scene);
    scene.step();
    scene.run_until(1, sph::Guard<2>(), sph::Snapshots("x"));
}
