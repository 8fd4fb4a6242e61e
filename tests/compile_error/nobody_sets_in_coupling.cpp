// The wall has no pressure: the coupling's pressure gradient reads it there.
// expect: NobodySets<imbibe::Pressure, imbibe::SymmetricPressure<imbibe::WendlandC2>, Tank,
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Tank : sph::Wall<> {};
struct Sides : sph::Coupling<Water, Tank, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, Sides>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
