// A term for both sides of a coupling, and once more for one of them.
// expect: the same term is listed twice
// expect: TermTwice<imbibe::KernelRepulsion<
// expect: Contact, imbibe::list_it_once>
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Stone : sph::Wall<> {};
struct Contact : sph::Coupling<Water, Stone, sph::KernelRepulsion<>, sph::Into<Water, sph::KernelRepulsion<>>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Stone, Contact>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
