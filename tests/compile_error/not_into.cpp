// A wall's pressure that is not said to go into the wall.
// expect: this term is one of a wall or a solid beside a fluid, and acts on just that
// expect: NotInto<imbibe::PressureExtrapolation<
// expect: write_it_in_a_coupling_as_Into_the_wall_or_solid
#include "scene.hpp"

#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::VolumePressure<K>> {};
struct Tank : sph::Wall<> {};
struct Sides : sph::Coupling<Water, Tank, sph::PressureExtrapolation<K>, sph::VolumePressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, Sides>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
