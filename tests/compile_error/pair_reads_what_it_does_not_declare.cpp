// A pair term reads a field of its neighbour that is missing from its `reads`.
// expect: this term reads a field that is missing from its `reads`: add it there
// expect: ReadsWhatItDoesNotDeclare<imbibe::Velocity, Drag>
#include "scene.hpp"

struct Drag {
    using reads = sph::Fields<sph::mass>;
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
