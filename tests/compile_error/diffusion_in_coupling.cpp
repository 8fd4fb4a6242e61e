// A diffusion of the density across an interface, where densities differ for good reason.
// expect: this term compares neighbours of one material, and is listed in a coupling
// expect: NotInCouplings<imbibe::DensityDiffusion<
// expect: list_it_in_the_phases_only
#include "scene.hpp"

#include <imbibe/fluid/density_diffusion.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Oil : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Interface : sph::Coupling<Water, Oil, sph::Continuity<K>, sph::DensityDiffusion<K>, sph::SymmetricPressure<K>> {
};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Oil, Interface>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
