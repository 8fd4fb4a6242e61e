// Particles of a phase that the scene does not have.
// expect: the scene does not have this phase or coupling
// expect: NotInTheScene<Oil
// expect: list_the_phase_in_the_solver
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Oil : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.add(Oil{{.density = 900, .sound_speed = 10}}, {{0, 0}}, 0.1);
}
