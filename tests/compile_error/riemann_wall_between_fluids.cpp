// The pressure of a Riemann wall between two fluids.
// expect: this term goes between a fluid and a wall or a solid
// expect: NotBetweenFluidAndWall<imbibe::RiemannWallPressure<
// expect: use_VolumePressure_RiemannPressure_or_MorrisViscosity_between_fluids
#include "scene.hpp"

#include <imbibe/wall/riemann_wall.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>> {};
struct Oil : sph::Fluid<sph::Tait<>, sph::Continuity<K>> {};
struct Contact : sph::Coupling<Water, Oil, sph::Into<Water, sph::RiemannWallNormal<K>>,
                               sph::Into<Oil, sph::RiemannWallNormal<K>>, sph::RiemannWallPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Oil, Contact>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
