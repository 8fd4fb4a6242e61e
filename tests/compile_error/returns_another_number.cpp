// One value for two fields.
// expect: this term returns more or fewer values than the fields it sets or adds to: for several fields a std::tuple
// expect: ReturnsAnotherNumber<Both>
#include "scene.hpp"

struct Both {
    using reads = sph::Fields<sph::mass>;
    using adds = sph::Fields<sph::density_rate, sph::acceleration>;
    constexpr auto operator()(const auto&, const auto& b, const auto& ab) const { return b[sph::mass] * ab.value(K{}); }
};
struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>, Both> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
