// The density by summation is to be evaluated once in a long step: it would lag behind the particles.
// expect: a term that is to be evaluated less often changes a state in every short step
// expect: SlowTermOfState<
// expect: let_every_short_step_evaluate_it
#include "scene.hpp"

#include <imbibe/fluid/summation_density.hpp>
#include <imbibe/time/dual_stepping.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::SummationDensity<K>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, sph::DualStepping<sph::SummationDensity<K>>, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
