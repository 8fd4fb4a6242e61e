// A diffusion of the density by gradients over the fluid alone, corrected as if the wall counted.
// expect: a term of this phase is wrong beside this one in a coupling
// expect: NeverInCoupling<imbibe::CorrectionNeighbours<
// expect: remove_one_of_the_two_terms
#include "scene.hpp"

#include <imbibe/fluid/corrected_gradients.hpp>
#include <imbibe/fluid/gradient_correction.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::CurrentCorrection<K>, sph::CorrectedContinuity<K>, sph::AntuonoDiffusion<K>,
                          sph::CorrectedPressure<K>> {};
struct Tank : sph::Wall<> {};
struct Sides : sph::Coupling<Water, Tank, sph::Into<Water, sph::CorrectionNeighbours<K>>,
                             sph::Into<Water, sph::CorrectedContinuity<K>>,
                             sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::CorrectedPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, Sides>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
