// The scene that the other programs break in one place each.
// expect: nothing
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Tank : sph::Wall<sph::Tait<>> {};
struct Sides : sph::Coupling<Water, Tank, sph::SymmetricPressure<K>, sph::VolumeContinuity<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, Sides>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
