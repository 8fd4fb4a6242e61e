// A coupling to a phase that the scene does not have.
// expect: this coupling names a phase that the scene does not have
// expect: NoSuchPhase<Sponge, Contact,
// expect: list_every_phase_of_a_coupling_in_the_solver
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Sponge : sph::Solid<sph::LinearState, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Contact : sph::Coupling<Water, Sponge, sph::KernelRepulsion<>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Contact>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
