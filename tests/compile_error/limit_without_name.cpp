// A limit on the step that has no name.
// expect: this term's limit on the step has no name, or cannot be called
// expect: LimitNotUsable<Spring, imbibe::write_time_step_limit_of_the_material_and_TimeStepInput_with_a_limit_name>
#include "scene.hpp"

struct Spring {
    using reads = sph::Fields<sph::position>;
    using adds = sph::Fields<sph::acceleration>;
    constexpr auto operator()(const auto& a) const { return -1e6 * a[sph::position]; }
    static double time_step_limit(const auto&, const sph::TimeStepInput&) { return 2e-3; }
};
struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>, Spring> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
