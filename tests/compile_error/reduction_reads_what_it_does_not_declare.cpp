// A reduction that reads a field which it does not declare.
// expect: this term reads a field that is missing from its `reads`: add it there
// expect: ReadsWhatItDoesNotDeclare<
// expect: Measure::Pressure>
#include "scene.hpp"

struct Total {
    static constexpr std::string_view name = "total", unit = "Pa";
};
struct Measure : sph::NotStiff {
    struct Pressure {
        using reads = sph::Fields<>;
        using reduces = sph::Sum<Total>;
        double operator()(const auto& a) const { return a[sph::mass]; }
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
