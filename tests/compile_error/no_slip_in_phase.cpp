// The viscosity at a wall to which water sticks, listed in the water.
// expect: this term goes between a fluid and a wall or a solid, and is listed in a phase
// expect: NotInPhases<imbibe::NoSlipViscosity<
// expect: list_it_in_a_coupling_of_the_fluid
#include "scene.hpp"

#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/wall/no_slip.hpp>

struct Water
    : sph::Fluid<sph::Tait<>, sph::VolumeContinuity<K>, sph::VolumePressure<K>, sph::NoSlipViscosity<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
