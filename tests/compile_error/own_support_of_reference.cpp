// A term over reference neighbours that says itself how far it reaches: those are kept as far as the phase reaches.
// expect: a sum over reference neighbours reaches as far as its phase, not further
// expect: OwnSupportOfReferenceNeighbours<
// expect: imbibe::remove_its_support_radius_or_use_current_neighbours>
#include "scene.hpp"

struct Bond {
    static double support_radius(const auto& material) { return 5 * material.spacing; }
    using neighbourhood = sph::Reference;
    using reads = sph::Fields<sph::mass>;
    using adds = sph::Fields<sph::acceleration>;
    constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
        return along(ab, b[sph::mass] * ab.value(K{}));
    }
};
struct Block : sph::Solid<Bond> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Block>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
