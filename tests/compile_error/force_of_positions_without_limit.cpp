// A spring that does not say how long steps may be.
// expect: this term's force depends on positions, and it does not say what steps it bears
// expect: ForceOfPositionsWithoutLimit<Spring, Water, imbibe::write_a_time_step_limit_with_a_limit_name_or_derive_it
#include "scene.hpp"

struct Spring {
    using reads = sph::Fields<sph::position>;
    using adds = sph::Fields<sph::acceleration>;
    constexpr auto operator()(const auto& a) const { return -1e6 * a[sph::position]; }
};
struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>, Spring> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
