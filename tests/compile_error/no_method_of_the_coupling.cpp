// A coupling by the method of a fluid that lists none.
// expect: no method of the first phase of this CouplingOf says what acts between the two
// expect: NoMethodOfTheCoupling<Water, Stone, imbibe::list_the_terms_in_a_Coupling>
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Stone : sph::Wall<> {};
struct Contact : sph::CouplingOf<Water, Stone> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Stone, Contact>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
