// Pressure from temperature and temperature from pressure. The pressure gradient only waits for them.
// expect: these terms wait for each other's results
// expect: Cycle<
// expect: GasLaw
// expect: Adiabatic
// expect: make_one_of_the_two_terms_read_something_else
#include "scene.hpp"

struct Temperature : sph::Field<sph::Rank::scalar> {
    static constexpr std::string_view name = "temperature", unit = "K";
};
inline constexpr Temperature temperature{};
struct GasLaw {
    using reads = sph::Fields<sph::density, temperature>;
    using sets = sph::Fields<sph::pressure>;
    constexpr auto operator()(const auto& a) const { return 287 * a[sph::density] * a[temperature]; }
};
struct Adiabatic {
    using reads = sph::Fields<sph::pressure>;
    using sets = sph::Fields<temperature>;
    constexpr auto operator()(const auto& a) const { return 293 + 1e-5 * a[sph::pressure]; }
};
struct Gas : sph::Fluid<sph::SymmetricPressure<K>, GasLaw, Adiabatic> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Gas>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
