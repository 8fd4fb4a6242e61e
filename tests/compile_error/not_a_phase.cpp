// Something that is no phase among the phases of a scene.
// expect: NotAPhaseOrCoupling<int
// expect: the solver lists this, which is no phase and no coupling
// expect: list_structs_derived_from_Fluid_Solid_Wall_or_Coupling
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, int>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
