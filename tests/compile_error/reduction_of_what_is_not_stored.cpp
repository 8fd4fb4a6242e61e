// A reduction that reads a field which its phase does not store: nothing sets it.
// expect: a reduction reads a field that its phase does not store
// expect: ReducesWhatIsNotStored<
// expect: imbibe::let_another_term_of_the_phase_set_it>
#include "scene.hpp"

struct Total {
    static constexpr std::string_view name = "total", unit = "Pa";
};
struct Measure : sph::NotStiff {
    struct Pressure {
        using reads = sph::Fields<sph::pressure>;
        using reduces = sph::Sum<Total>;
        double operator()(const auto& a) const { return a[sph::pressure]; }
    };
    using parts = sph::Parts<>;
    using reductions = sph::Parts<Pressure>;
};
struct Water : sph::Fluid<Measure> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
