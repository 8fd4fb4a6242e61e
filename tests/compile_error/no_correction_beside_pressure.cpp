// A corrected pressure whose correction does not know the wall that pushes beside it.
// expect: a term of this phase needs another in this coupling
// expect: MissingInCoupling<imbibe::CorrectionNeighbours<
// expect: list_it_in_the_coupling_Into_the_phase
#include "scene.hpp"

#include <imbibe/fluid/corrected_gradients.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::CurrentCorrection<K>, sph::VolumeContinuity<K>, sph::CorrectedPressure<K>> {
};
struct Tank : sph::Wall<> {};
struct Sides : sph::Coupling<Water, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::CorrectedPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, Sides>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
