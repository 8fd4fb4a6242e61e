// A fluid whose motion is prescribed: forces would act on it all the same.
// expect: fluids and solids are Free, walls are Placed or Prescribed
// expect: MotionOfAnotherKind<
// expect: Water, imbibe::derive_the_phase_from_Wall_to_prescribe_its_motion>
#include "scene.hpp"

struct Water : sph::Fluid<> {
    using motion = sph::Prescribed;
};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
