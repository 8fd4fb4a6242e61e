// A term that counts neighbours with nothing that vanishes at the support radius.
// expect: this term counts neighbours beyond the support radius, which are not all there: multiply by a kernel
// expect: ReachesBeyondTheSupport<Count>
#include "scene.hpp"

struct Count {
    using reads = sph::Fields<sph::mass>;
    using adds = sph::Fields<sph::density_rate>;
    constexpr auto operator()(const auto&, const auto& b, const auto&) const { return b[sph::mass]; }
};
struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>, Count> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
