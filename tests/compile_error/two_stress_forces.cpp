// A solid whose stress pushes twice, by where its particles are now and by where they were when it was stress-free.
// expect: two terms are forms of the same equation, which would count twice
// expect: SameEffectTwice<imbibe::effects::pressure_force, imbibe::StressForce<
// expect: imbibe::TotalLagrangianForce<
// expect: Block, imbibe::remove_one_of_the_two_terms>
#include "scene.hpp"

#include <imbibe/solid/stress_force.hpp>
#include <imbibe/solid/total_lagrangian.hpp>

struct Block : sph::Solid<sph::StressForce<K>, sph::ReferenceCorrection<K>, sph::DeformationGradient<K>,
                          sph::StVenantKirchhoff, sph::TotalLagrangianForce<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Block>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
