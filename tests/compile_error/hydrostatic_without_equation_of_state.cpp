// A phase that starts with the pressure of its own weight, but has no equation of state that says its density there.
// expect: NoDensityAtAPressure
// expect: no term of this phase says its density at a pressure
// expect: Dust
// expect: add_an_equation_of_state_with_density_at_such_as_Tait
#include "scene.hpp"

#include <imbibe/state/hydrostatic.hpp>

struct Dust : sph::Fluid<sph::Continuity<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Dust>;

int main() {
    Scene scene({.gravity = {0, -10}, .support_radius = 0.1});
    const auto dust = scene.add(Dust{{.density = 1000, .sound_speed = 10}}, {{0, 0}}, 0.04);
    sph::start_hydrostatic(scene, dust, 1);
}
