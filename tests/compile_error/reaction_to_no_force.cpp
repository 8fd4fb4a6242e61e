// The reaction to a term that is no force.
// expect: ReactionForce is given a term that pushes nothing
// expect: NoForceToReactTo<imbibe::VolumeContinuity<
// expect: give_it_a_force_of_the_coupling
#include "scene.hpp"

#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>
#include <imbibe/wall/reaction_force.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::VolumeContinuity<K>, sph::VolumePressure<K>> {};
struct Tank : sph::Wall<> {};
struct Sides : sph::Coupling<Water, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                             sph::Into<Water, sph::VolumeContinuity<K>>,
                             sph::Into<Tank, sph::ReactionForce<sph::VolumeContinuity<K>>>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, Sides>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
