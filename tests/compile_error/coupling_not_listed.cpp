// The coefficients of a coupling that the scene does not have.
// expect: the scene does not have this phase or coupling
// expect: NotInTheScene<Contact
// expect: list_the_coupling_in_the_solver
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Stone : sph::Wall<> {};
struct Contact : sph::Coupling<Water, Stone, sph::KernelRepulsion<>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Stone>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.coupling<Contact>().set(sph::KernelRepulsionParameters{.stiffness = 1});
}
