// An integrator that names a phase which the scene does not have.
// expect: the scene does not have this phase or coupling
// expect: NotInTheScene<Gate
// expect: list_the_phase_in_the_solver
#include "scene.hpp"

#include <imbibe/time/subcycled.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Gate : sph::Solid<sph::TimeAveragedMotion> {};
using Scene = sph::Solver<2, double, sph::Subcycled<Gate>, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
