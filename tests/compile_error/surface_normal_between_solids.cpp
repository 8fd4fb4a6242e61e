// The pressure along a solid's normals between two solids: neither is the fluid whose pressure it is.
// expect: this term goes between a fluid and a wall or a solid
// expect: NotBetweenFluidAndWall<imbibe::SurfaceNormalPressure<
// expect: list_it_between_a_fluid_and_a_wall_or_solid
#include "scene.hpp"

#include <imbibe/coupling/surface_normal.hpp>

struct Block : sph::Solid<sph::LinearState, sph::Continuity<K>, sph::SurfaceNormal<K>, sph::SymmetricPressure<K>> {};
struct Ball : sph::Solid<sph::LinearState, sph::Continuity<K>, sph::SurfaceNormal<K>, sph::SymmetricPressure<K>> {};
struct Contact : sph::Coupling<Block, Ball, sph::SurfaceNormalPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Block, Ball, Contact>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
