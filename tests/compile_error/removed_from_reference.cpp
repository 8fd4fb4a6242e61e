// Particles of a total-Lagrangian solid are to be removed.
// expect: the particles of a total-Lagrangian phase cannot be removed
// expect: RemovedFromReference<Block
// expect: remove_particles_of_other_phases_only
#include "scene.hpp"

#include <imbibe/solid/total_lagrangian.hpp>

struct Block : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::StVenantKirchhoff,
                          sph::TotalLagrangianForce<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Block>;

int main() {
    Scene scene({.support_radius = 0.1});
    const auto block =
        scene.add(Block{{.density = 1000, .sound_speed = 30, .shear_modulus = 1e5}}, {{0, 0}, {0.1, 0}}, 0.1);
    scene.remove_if(block, [](const auto& x) { return x[0] < 0; });
}
