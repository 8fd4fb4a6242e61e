// An integrator names a term that no phase or coupling has.
// expect: the integrator names this term, which no phase or coupling of the scene lists
// expect: TermNotInTheScene<
// expect: list_it_in_a_phase_or_coupling_or_do_not_name_it
#include "scene.hpp"

#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/time/dual_stepping.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, sph::DualStepping<sph::MorrisViscosity<K>>, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
