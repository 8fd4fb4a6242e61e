// Water that freezes onto a total-Lagrangian solid, in which it has no stress-free place.
// expect: particles cannot be handed over to a total-Lagrangian phase
// expect: HandedToReference<
// expect: imbibe::take_a_solid_with_a_stress_rate>
#include "scene.hpp"

#include <imbibe/solid/deformation_gradient.hpp>
#include <imbibe/solid/reference_correction.hpp>

struct Water : sph::Fluid<> {};
struct Ice : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Ice>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.hand_over(sph::PhaseHandle<Water>{}, sph::PhaseHandle<Ice>{}, [](const auto&) { return true; });
}
