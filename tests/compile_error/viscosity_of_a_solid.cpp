// A solid with the viscosity of a liquid.
// expect: NoViscosity<imbibe::MorrisViscosity
// expect: list_it_where_a_phase_has_a_viscosity_as_fluids_and_walls_do
#include "scene.hpp"

#include <imbibe/fluid/morris_viscosity.hpp>

struct Jelly : sph::Solid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>, sph::MorrisViscosity<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Jelly>;

int main() {
    Scene scene({.support_radius = 0.1});
}
