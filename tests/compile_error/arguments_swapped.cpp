// The integrator in the place of the numbers, which are not given.
// expect: NotRealNumbers<imbibe::SymplecticEuler
// expect: the numbers of a scene are float or double
// expect: write_float_or_double
#include "scene.hpp"

#include <imbibe/monitor/guard.hpp>
#include <imbibe/output/snapshots.hpp>
#include <imbibe/solver/describe.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Tank : sph::Wall<sph::Tait<>> {};
struct Sides : sph::Coupling<Water, Tank, sph::SymmetricPressure<K>, sph::VolumeContinuity<K>> {};
using Scene = sph::Solver<2, sph::SymplecticEuler, Water, Tank, Sides>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.add(Water{{.density = 1000, .sound_speed = 10}}, {{0, 0}}, 0.1);
    describe(scene);
    scene.step();
    scene.run_until(1, sph::Guard<2>(), sph::Snapshots("x"));
}
