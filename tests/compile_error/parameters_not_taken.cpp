// The member that should be filled with the parameters of a term has another name.
// expect: nothing in this term takes its `Parameters`: what is set would be ignored
// expect: ParametersNotTaken<Drag::Parameters, Drag
// expect: give_the_part_that_uses_them_a_member_of_this_type_named_parameters
#include "scene.hpp"

#include <imbibe/monitor/guard.hpp>
#include <imbibe/output/snapshots.hpp>
#include <imbibe/solver/describe.hpp>

struct Drag {
    using reads = sph::Fields<sph::velocity>;
    using adds = sph::Fields<sph::acceleration>;
    struct Parameters {
        double rate = 1;
    };
    Parameters coefficients{};
    constexpr auto operator()(const auto& a) const { return -coefficients.rate * a[sph::velocity]; }
};
struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>, Drag> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    Water water{{.density = 1000, .sound_speed = 10}};
    water.set(Drag::Parameters{.rate = 2});
    scene.add(water, {{0, 0}}, 0.1);
    describe(scene);
    scene.step();
    scene.run_until(1, sph::Guard<2>(), sph::Snapshots("x"));
}
