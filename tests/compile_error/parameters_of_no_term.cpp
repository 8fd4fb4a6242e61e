// Coefficients of a term that the phase does not have.
// expect: no term of this phase or coupling has these parameters
// expect: NoTermHasTheseParameters<imbibe::KernelRepulsionParameters
// expect: list_the_term_that_they_are_of
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    Water water{{.density = 1000, .sound_speed = 10}};
    water.set(sph::KernelRepulsionParameters{.stiffness = 1});
    scene.add(water, {{0, 0}}, 0.1);
}
