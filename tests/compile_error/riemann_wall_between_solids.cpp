// The pressure of a Riemann wall where there is no fluid.
// expect: this term goes between a fluid and a wall or a solid
// expect: list_it_between_a_fluid_and_a_wall_or_solid
#include "scene.hpp"

#include <imbibe/wall/riemann_wall.hpp>

struct Block : sph::Solid<sph::LinearState> {};
struct Ball : sph::Solid<sph::LinearState> {};
struct Contact : sph::Coupling<Block, Ball, sph::Into<Block, sph::RiemannWallNormal<K>>,
                               sph::Into<Ball, sph::RiemannWallNormal<K>>, sph::RiemannWallPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Block, Ball, Contact>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
