// Tait's equation with an exponent of 0.
// expect: the exponent gamma of Tait must be a whole number from 1 on
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<0>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.step();
}
