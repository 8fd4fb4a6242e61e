// The reaction to a force with another kernel than the coupling's.
// expect: this force is none of the coupling, which lists a reaction to it
// expect: NothingToReactTo<imbibe::VolumePressure<imbibe::CubicSpline
// expect: give_it_a_force_that_the_coupling_lists
#include "scene.hpp"

#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/kernels/cubic_spline.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>
#include <imbibe/wall/reaction_force.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::VolumeContinuity<K>, sph::VolumePressure<K>> {};
struct Tank : sph::Wall<> {};
struct Sides : sph::Coupling<Water, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                             sph::Into<Water, sph::VolumeContinuity<K>>,
                             sph::Into<Tank, sph::ReactionForce<sph::VolumePressure<sph::CubicSpline>>>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, Sides>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
