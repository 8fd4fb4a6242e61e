// What acts on one side of a coupling, in a phase.
// expect: this is listed where a term is expected, and is none
// expect: NotATerm<imbibe::Into<
// expect: Water, imbibe::list_terms_only_and_Into_only_in_couplings>
#include "scene.hpp"

struct Stone : sph::Wall<> {};
struct Water
    : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>, sph::Into<Stone, sph::KernelRepulsion<>>> {
};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
