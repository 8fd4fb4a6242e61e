// A kernel without its derivative.
// expect: a term asks this kernel for a function that it does not have
// expect: KernelLacksAFunction<Hat
// expect: give_it_derivative_of_q
#include "scene.hpp"

#include <imbibe/monitor/guard.hpp>
#include <imbibe/output/snapshots.hpp>
#include <imbibe/solver/describe.hpp>

struct Hat {
    static constexpr const char* name = "hat";
    template <int dim>
    static constexpr double normalisation() {
        return 1;
    }
    template <class T>
    static constexpr T value(T q) {
        return sph::positive_part(T(1) - q);
    }
};
struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<Hat>, sph::SymmetricPressure<Hat>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.add(Water{{.density = 1000, .sound_speed = 10}}, {{0, 0}}, 0.1);
    describe(scene);
    scene.step();
    scene.run_until(1, sph::Guard<2>(), sph::Snapshots("x"));
}
