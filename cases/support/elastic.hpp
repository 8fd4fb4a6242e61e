// An elastic solid of the benchmarks from the numbers of an engineer.
#pragma once

#include <imbibe/core/phase.hpp>

namespace imbibe::bench {

/// A solid P with Young's modulus, Pa, Poisson's ratio and density, kg/m^3.
template <class P>
P elastic(double young, double poisson, double density) {
    P solid;
    solid.density = density;
    solid.sound_speed = sound_speed_of(young, poisson, density);
    solid.shear_modulus = shear_modulus_of(young, poisson);
    return solid;
}

} // namespace imbibe::bench
