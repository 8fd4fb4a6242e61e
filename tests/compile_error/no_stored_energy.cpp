// The elastic energy of water, whose terms know of none.
// expect: NoStoredEnergy
// expect: no term of this phase has a stored_energy
// expect: Block, imbibe::list_a_law_with_stored_energy_such_as_CompressibleNeoHookean>
#include "scene.hpp"

#include <imbibe/monitor/energy.hpp>
#include <imbibe/solid/deformation_gradient.hpp>
#include <imbibe/solid/reference_correction.hpp>

struct Block : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Block>;

double energy(Scene& scene, sph::PhaseHandle<Block> block) {
    return sph::elastic_energy<2>(scene[block]);
}
