// The paper's viscosity kernel of space, in the plane.
// expect: KernelOfAnotherDimension
// expect: this kernel is not made for this dimension
// expect: ViscosityKernel
// expect: use_ViscosityKernel2D_in_the_plane
#include "scene.hpp"

#include <imbibe/fluid/laminar_viscosity.hpp>
#include <imbibe/kernels/viscosity_kernel.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::LaminarViscosity<sph::ViscosityKernel>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
