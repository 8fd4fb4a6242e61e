// A phase takes shorter steps than the scene, and does not average its motion for the others.
// expect: the phase that Subcycled names does not average its motion
// expect: SubcycledWithoutMean<Gate
// expect: list_the_term_TimeAveragedMotion_in_the_phase
#include "scene.hpp"

#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/time/subcycled.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Gate : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::StVenantKirchhoff,
                         sph::TotalLagrangianForce<K>> {};
using Scene = sph::Solver<2, double, sph::Subcycled<Gate>, Water, Gate>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
