// The function of a term is not const.
// expect: this term has no function `operator()(a) const` or `operator()(a, b, ab) const`
// expect: NotCallable<Drag>
#include "scene.hpp"

struct Drag {
    using reads = sph::Fields<sph::velocity>;
    using adds = sph::Fields<sph::acceleration>;
    constexpr auto operator()(const auto& a) { return -0.1 * a[sph::velocity]; }
};
struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>, Drag> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
