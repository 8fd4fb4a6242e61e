// Something else than a kernel as the kernel of a term.
// expect: a term is given this where it takes a kernel, such as WendlandC2
// expect: NotAKernel<imbibe::Tait<
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<sph::Tait<>>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
