// A term says how far it reaches by a function that cannot be called with its phase.
// expect: this term's support_radius cannot be asked for
// expect: SupportRadiusNotUsable<
// expect: imbibe::write_static_double_support_radius_of_a_material_or_of_two>
#include "scene.hpp"

struct Pull : sph::NotStiff {
    static double support_radius(double spacing) { return 5 * spacing; }
    using reads = sph::Fields<sph::mass>;
    using adds = sph::Fields<sph::acceleration>;
    constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
        return along(ab, b[sph::mass] * ab.value(K{}));
    }
};
struct Water : sph::Fluid<Pull> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
