// A kernel where a term is expected.
// expect: this is listed where a term is expected, and is none
// expect: NotATerm<imbibe::WendlandC2, Water
// expect: list_terms_only_and_Into_only_in_couplings
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>, K> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
