// A term lists a field in `reads` that it never looks at.
// expect: this term lists a field in `reads` that it never reads: remove it there
// expect: DeclaresWhatItDoesNotRead<imbibe::Density, Drag>
#include "scene.hpp"

struct Drag {
    using reads = sph::Fields<sph::mass, sph::density, sph::velocity>;
    using adds = sph::Fields<sph::acceleration>;
    constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        return b[sph::mass] * ab.value(K{}) * (b[sph::velocity] - a[sph::velocity]);
    }
};
struct Air : sph::Fluid<Drag> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Air>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
