// The wall has no pressure: the coupling's pressure gradient reads it there.
// expect: a term reads this field, and no term of its phase sets it
// expect: NobodySets<imbibe::Pressure, imbibe::SymmetricPressure<imbibe::WendlandC2>, Tank,
// expect: add_PressureExtrapolation_to_the_coupling_Into_the_wall
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Tank : sph::Wall<> {};
struct Sides : sph::Coupling<Water, Tank, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, Sides>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
