// A scene whose numbers are whole.
// expect: the numbers of a scene are float or double
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, int, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
}
