// A term of a coupling is sent into a phase that is not one of its two.
// expect: this coupling names a phase that the scene does not have
// expect: NoSuchPhase<Sponge, Sides,
// expect: list_every_phase_of_a_coupling_in_the_solver
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Sponge : sph::Solid<sph::LinearState, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Tank : sph::Wall<sph::Tait<>> {};
struct Sides : sph::Coupling<Water, Tank, sph::Into<Sponge, sph::SymmetricPressure<K>>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Sponge, Tank, Sides>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
