// Two forms of the equation of continuity: the density would change twice as fast.
// expect: two terms are forms of the same equation, which would count twice
// expect: SameEffectTwice<imbibe::effects::continuity_equation, imbibe::Continuity<
// expect: imbibe::VolumeContinuity<
// expect: Water, imbibe::remove_one_of_the_two_terms>
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::VolumeContinuity<K>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
