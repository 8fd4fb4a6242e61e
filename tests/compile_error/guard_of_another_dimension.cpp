// A guard made for space in a scene of the plane, whose wall it would look through for pores.
// expect: GuardOfAnotherDimension
// expect: a Guard is of its scene's dimension: replace the first by the second
// expect: Guard<3>
#include "scene.hpp"

#include <imbibe/monitor/guard.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Tank : sph::Wall<sph::Tait<>> {};
struct Sides : sph::Coupling<Water, Tank, sph::SymmetricPressure<K>, sph::VolumeContinuity<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, Sides>;

int main() {
    Scene scene({.support_radius = 0.1});
    sph::Guard<3> guard;
    guard.look(scene);
    scene.run_until(1, guard);
}
