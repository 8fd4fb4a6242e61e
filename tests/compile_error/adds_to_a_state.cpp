// A term adds to the velocity where it means the acceleration.
// expect: a term adds to a state, which would start from zero in every step
// expect: AddsToAState<imbibe::Velocity, Wind, Water
// expect: let_the_part_add_to_its_rate_or_set_it
#include "scene.hpp"

struct Wind {
    using reads = sph::Fields<sph::acceleration>;
    using adds = sph::Fields<sph::velocity>;
    constexpr auto operator()(const auto& a) const { return 0.1 * a[sph::acceleration]; }
};
struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>, Wind> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
