// A number in the place of the integrator.
// expect: NotAnIntegrator<int
// expect: the third argument of a solver is no integrator
// expect: give_it_one_such_as_SymplecticEuler
#include "scene.hpp"

#include <imbibe/monitor/guard.hpp>
#include <imbibe/output/snapshots.hpp>
#include <imbibe/solver/describe.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, int, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.add(Water{{.density = 1000, .sound_speed = 10}}, {{0, 0}}, 0.1);
    describe(scene);
    scene.step();
    scene.run_until(1, sph::Guard<2>(), sph::Snapshots("x"));
}
