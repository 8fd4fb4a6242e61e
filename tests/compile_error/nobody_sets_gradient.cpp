// A rate of stress without the velocity gradient that it follows.
// expect: a term reads this field, and no term of its phase sets it
// expect: NobodySets<imbibe::VelocityGradientField, imbibe::JaumannStress, Rubber
// expect: add_a_term_that_sets_it
#include "scene.hpp"

#include <imbibe/solid/jaumann_stress.hpp>
#include <imbibe/solid/stress_force.hpp>

struct Rubber : sph::Solid<sph::LinearState, sph::Continuity<K>, sph::JaumannStress, sph::StressForce<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Rubber>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
