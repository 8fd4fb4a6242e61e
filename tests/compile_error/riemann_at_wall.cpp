// The Riemann problem of two fluids, asked of a wall, which has no sound of its own.
// expect: this term goes between fluids, and a side of this coupling is none
// expect: NotBetweenFluids<imbibe::RiemannPressure<
// expect: use_the_RiemannWall_terms_at_walls_and_solids
#include "scene.hpp"

#include <imbibe/fluid/riemann.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

struct Water : sph::Fluid<sph::LinearState, sph::RiemannContinuity<K>, sph::RiemannPressure<K>> {};
struct Tank : sph::Wall<> {};
struct Sides : sph::Coupling<Water, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::RiemannPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, Sides>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
