// A scene whose numbers are whole.
// expect: NotRealNumbers
// expect: the numbers of a scene are float or double
// expect: int, imbibe::write_float_or_double>
#include "scene.hpp"

#include <imbibe/monitor/guard.hpp>
#include <imbibe/output/snapshots.hpp>
#include <imbibe/solver/describe.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, int, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.add(Water{{.density = 1000, .sound_speed = 10}}, {{0, 0}}, 0.1);
    describe(scene);
    scene.step();
    scene.run_until(1, sph::Guard<2>(), sph::Snapshots("x"));
}
