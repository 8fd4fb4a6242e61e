// A scene on a line.
// expect: NotTwoOrThreeDimensions
// expect: a scene or a shape has 2 or 3 dimensions
#include "scene.hpp"

#include <imbibe/kernels/cubic_spline.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<sph::CubicSpline>, sph::SymmetricPressure<sph::CubicSpline>> {};
using Scene = sph::Solver<1, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
}
