// A viscosity between two solids: neither has one.
// expect: NoViscosity<imbibe::LaminarViscosity
// expect: list_it_where_a_phase_has_a_viscosity_as_fluids_and_walls_do
#include "scene.hpp"

#include <imbibe/fluid/laminar_viscosity.hpp>

struct Left : sph::Solid<sph::Tait<>, sph::Continuity<K>> {};
struct Right : sph::Solid<sph::Tait<>, sph::Continuity<K>> {};
struct Contact : sph::Coupling<Left, Right, sph::LaminarViscosity<>> {};
using Scene = sph::Solver<3, double, sph::SymplecticEuler, Left, Right, Contact>;

int main() {
    Scene scene({.support_radius = 0.1});
}
