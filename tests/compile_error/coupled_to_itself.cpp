// A coupling of a phase with itself: what acts within a phase is a term of the phase.
// expect: this phase or coupling is listed twice, or a phase is coupled to itself
// expect: SamePhaseTwice<Water,
// expect: couple_two_different_phases
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Contact : sph::Coupling<Water, Water, sph::KernelRepulsion<>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Contact>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
