// A fluid with corrected gradients on a wall whose particles are not among the neighbours that correct them.
// expect: a term of this phase needs another in this coupling
// expect: MissingInCoupling<imbibe::CorrectionNeighbours<
// expect: imbibe::CorrectedContinuity<
// expect: Water, OnFloor
// expect: list_it_in_the_coupling_Into_the_phase
#include "scene.hpp"

#include <imbibe/fluid/corrected_gradients.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

struct Water
    : sph::Fluid<sph::Tait<>, sph::CurrentCorrection<K>, sph::CorrectedContinuity<K>, sph::CorrectedPressure<K>> {};
struct Floor : sph::Wall<> {};
struct OnFloor : sph::Coupling<Water, Floor, sph::Into<Floor, sph::PressureExtrapolation<K>>, sph::CorrectedPressure<K>,
                               sph::Into<Water, sph::CorrectedContinuity<K>>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Floor, OnFloor>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
