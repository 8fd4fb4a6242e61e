// A coupling sends a spring into its fluid, in two parts, of which the first alone reads positions.
// expect: this term's force depends on positions, and it does not say what steps it bears
// expect: ForceOfPositionsWithoutLimit<Tether, Sides, imbibe::write_a_time_step_limit_with_a_limit_name_or_derive_it
#include "scene.hpp"

struct Pull : sph::Field<sph::Rank::vector> {
    static constexpr std::string_view name = "pull", unit = "m/s^2";
};
inline constexpr Pull pull{};
struct Tether {
    struct Measure {
        using reads = sph::Fields<sph::position>;
        using sets = sph::Fields<pull>;
        constexpr auto operator()(const auto& a) const { return -1e6 * a[sph::position]; }
    };
    struct Apply {
        using reads = sph::Fields<pull>;
        using adds = sph::Fields<sph::acceleration>;
        constexpr auto operator()(const auto& a) const { return a[pull]; }
    };
    using parts = sph::Parts<Measure, Apply>;
};
struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Tank : sph::Wall<sph::Tait<>> {};
struct Sides : sph::Coupling<Water, Tank, sph::Into<Water, Tether>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, Sides>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
