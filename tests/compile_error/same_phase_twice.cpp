// A phase that is listed twice.
// expect: this phase or coupling is listed twice, or a phase is coupled to itself
// expect: SamePhaseTwice<Water,
// expect: list_each_phase_and_coupling_once
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
