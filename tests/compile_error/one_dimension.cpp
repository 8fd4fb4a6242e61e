// A scene on a line, with a kernel that has no line: the kernel is not a second error.
// expect: NotTwoOrThreeDimensions
// expect: a scene or a shape has 2 or 3 dimensions
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<1, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
