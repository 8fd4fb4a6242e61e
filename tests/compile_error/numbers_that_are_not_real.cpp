// A scene whose numbers are whole.
// expect: NotRealNumbers
// expect: the numbers of a scene are float or double
// expect: int
// expect: write_float_or_double
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, int, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
}
