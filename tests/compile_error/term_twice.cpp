// A force that is listed twice would be twice as great.
// expect: the same term is listed twice
// expect: TermTwice<imbibe::KernelRepulsion<
// expect: Water, imbibe::list_it_once>
#include "scene.hpp"

struct Water : sph::Fluid<sph::KernelRepulsion<>, sph::KernelRepulsion<>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
