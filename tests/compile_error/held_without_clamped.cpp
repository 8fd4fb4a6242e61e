// Particles of a phase are to be held that no term can hold.
// expect: particles of this phase are to be held, and it has no term that holds them
// expect: HeldWithoutClamped<Block
// expect: list_the_term_Clamped_in_the_phase
#include "scene.hpp"

struct Block : sph::Solid<sph::LinearState, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Block>;

int main() {
    Scene scene({.support_radius = 0.1});
    const auto block = scene.add(Block{{.density = 1000, .sound_speed = 30}}, {{0, 0}}, 0.1);
    scene.hold(block, [](const auto& x) { return x[0] < 0; });
}
