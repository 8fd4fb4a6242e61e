// Dual stepping that does not say which terms are slow.
// expect: NothingIsSlow<imbibe::DualStepping<>
// expect: name_terms_such_as_MorrisViscosity
#include "scene.hpp"

#include <imbibe/time/dual_stepping.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, sph::DualStepping<>, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.step();
}
