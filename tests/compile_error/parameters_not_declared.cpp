// A term has parameters, and does not say of which type they are.
// expect: this term has a member `parameters` of this type, and no `using Parameters` of it
// expect: ParametersNotDeclared<Drag::Rates, Drag
// expect: write_using_Parameters_in_the_term
#include "scene.hpp"

#include <imbibe/monitor/guard.hpp>
#include <imbibe/output/snapshots.hpp>
#include <imbibe/solver/describe.hpp>

struct Drag {
    using reads = sph::Fields<sph::velocity>;
    using adds = sph::Fields<sph::acceleration>;
    struct Rates {
        double rate = 1;
    };
    Rates parameters{};
    constexpr auto operator()(const auto& a) const { return -parameters.rate * a[sph::velocity]; }
};
struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>, Drag> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    Water water{{.density = 1000, .sound_speed = 10}};
    water.set(Drag::Rates{.rate = 2});
    scene.add(water, {{0, 0}}, 0.1);
    describe(scene);
    scene.step();
    scene.run_until(1, sph::Guard<2>(), sph::Snapshots("x"));
}
