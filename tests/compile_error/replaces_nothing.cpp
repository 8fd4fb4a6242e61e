// A term is to be left out that neither the list nor a method in it has.
// expect: Instead<Old, ...> stands in a list without Old
// expect: NothingToReplace<imbibe::SymmetricPressure<imbibe::WendlandC2>
// expect: imbibe::list_the_term_itself_or_the_method_that_has_it>
#include "scene.hpp"

#include <imbibe/methods/weakly_compressible.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::WeaklyCompressible<K>, sph::Instead<sph::SymmetricPressure<K>>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
