// A function of a pair that sets a field: by which neighbour?
// expect: a function of a pair can only add to fields, and this one sets one
// expect: PairPartSets<NearestPressure, NearestPressure
// expect: let_the_part_add_to_the_field
#include "scene.hpp"

struct NearestPressure {
    using reads = sph::Fields<sph::density>;
    using sets = sph::Fields<sph::pressure>;
    constexpr auto operator()(const auto&, const auto& b, const auto&) const { return b[sph::density]; }
};
struct Water : sph::Fluid<NearestPressure, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
