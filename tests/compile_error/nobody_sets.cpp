// A fluid without an equation of state: nobody sets the pressure that the pressure gradient reads.
// expect: a term reads this field, and no term of its phase sets it
// expect: NobodySets<imbibe::Pressure, imbibe::SymmetricPressure<imbibe::WendlandC2>, Water,
// expect: add_an_equation_of_state_such_as_Tait
#include "scene.hpp"

struct Water : sph::Fluid<sph::Continuity<K>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
