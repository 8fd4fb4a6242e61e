// A number is added to a vector: the offset of the pair was forgotten.
// expect: what this term returns for this field is of another rank, such as a number for a vector
// expect: ReturnsAnotherRank<imbibe::Rate<imbibe::Velocity>, Pull>
#include "scene.hpp"

struct Pull {
    using reads = sph::Fields<sph::mass>;
    using adds = sph::Fields<sph::acceleration>;
    constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
        return b[sph::mass] * ab.gradient(K{});
    }
};
struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>, Pull> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
