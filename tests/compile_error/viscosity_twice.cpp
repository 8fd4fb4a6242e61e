// Two forms of the physical viscosity: the fluid would be twice as viscous.
// expect: two terms are forms of the same equation, which would count twice
// expect: SameEffectTwice<imbibe::effects::viscous_force, imbibe::MorrisViscosity<
// expect: remove_one_of_the_two_terms
#include "scene.hpp"

#include <imbibe/fluid/cleary_viscosity.hpp>
#include <imbibe/fluid/morris_viscosity.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>, sph::MorrisViscosity<K>,
                          sph::ClearyViscosity<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
