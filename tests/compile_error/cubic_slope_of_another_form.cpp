// A kernel whose cubic_slope is not that of its derivative.
// expect: CubicSlopeOfAnotherForm
// expect: a kernel's cubic_slope must be above 0, and its derivative_over_q(q) equal to -cubic_slope (1 - q)^3
// expect: Steep
#include "scene.hpp"

struct Steep : sph::WendlandC2 {
    static constexpr double cubic_slope = 10;
};
struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<Steep>, sph::SymmetricPressure<Steep>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.step();
}
