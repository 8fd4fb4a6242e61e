// A term with numbers to prepare whose function takes no lattice.
// expect: this term has `Prepared`, and no function `prepare` that returns one
// expect: PreparedByNoFunction<
// expect: imbibe::write_static_Prepared_prepare_of_a_material_or_two_and_a_Lattice>
#include "scene.hpp"

struct Pull : sph::NotStiff {
    struct Prepared {
        double strength = 1;
    };
    static Prepared prepare(double spacing) { return {1 / spacing}; }
    Prepared prepared;
    using reads = sph::Fields<sph::mass>;
    using adds = sph::Fields<sph::acceleration>;
    constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
        return along(ab, prepared.strength * b[sph::mass] * ab.value(K{}));
    }
};
struct Water : sph::Fluid<Pull> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
