// A term asks its numbers by `if`.
// expect: a term compares its numbers in an `if`
// expect: NumbersAskedByIf<imbibe::write_select_of_the_comparison_and_two_values
#include "scene.hpp"

#include <imbibe/monitor/guard.hpp>
#include <imbibe/output/snapshots.hpp>
#include <imbibe/solver/describe.hpp>

struct Drag {
    using reads = sph::Fields<sph::mass, sph::velocity>;
    using adds = sph::Fields<sph::acceleration>;
    constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        const auto relative = b[sph::velocity] - a[sph::velocity];
        if (dot(relative, ab.offset) > 0)
            return 0.1 * b[sph::mass] * ab.value(K{}) * relative;
        return 0.2 * b[sph::mass] * ab.value(K{}) * relative;
    }
};
struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>, Drag> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.add(Water{{.density = 1000, .sound_speed = 10}}, {{0, 0}}, 0.1);
    describe(scene);
    scene.step();
    scene.run_until(1, sph::Guard<2>(), sph::Snapshots("x"));
}
