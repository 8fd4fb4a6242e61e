// A particle term reads a field that is missing from its `reads`.
// expect: this term reads a field that is missing from its `reads`: add it there
// expect: ReadsWhatItDoesNotDeclare<imbibe::Density, Gas>
#include "scene.hpp"

struct Gas {
    using reads = sph::Fields<sph::mass>;
    using sets = sph::Fields<sph::pressure>;
    constexpr auto operator()(const auto& a) const { return 1e5 * a[sph::density] / a[sph::mass]; }
};
struct Air : sph::Fluid<Gas, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Air>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
