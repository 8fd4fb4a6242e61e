// One term computes a field once, another one in every step.
// expect: terms compute this field once, and others in every step
// expect: OnceAndInEveryStep<Depth, Water
// expect: remove_one_of_the_two_terms
#include "scene.hpp"

struct Depth : sph::Field<sph::Rank::scalar> {
    static constexpr std::string_view name = "depth", unit = "m";
};
inline constexpr Depth depth{};
struct AtTheStart {
    static constexpr bool once = true;
    using reads = sph::Fields<sph::position>;
    using sets = sph::Fields<depth>;
    constexpr auto operator()(const auto& a) const { return -a[sph::position][1]; }
};
struct Now {
    using reads = sph::Fields<sph::position>;
    using sets = sph::Fields<depth>;
    constexpr auto operator()(const auto& a) const { return -a[sph::position][1]; }
};
struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>, AtTheStart, Now> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
