// A law of elasticity in a phase that has no elastic moduli.
// expect: this term asks for the elastic moduli of a solid, and its phase has none
// expect: NotASolid<imbibe::StVenantKirchhoff, Water
// expect: give_it_to_a_solid
#include "scene.hpp"

#include <imbibe/monitor/guard.hpp>
#include <imbibe/output/snapshots.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/solver/describe.hpp>

struct Water : sph::Fluid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::StVenantKirchhoff,
                          sph::TotalLagrangianForce<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.add(Water{{.density = 1000, .sound_speed = 10}}, {{0, 0}}, 0.1);
    describe(scene);
    scene.step();
    scene.run_until(1, sph::Guard<2>(), sph::Snapshots("x"));
}
