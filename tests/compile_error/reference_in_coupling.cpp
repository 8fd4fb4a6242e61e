// A sum over reference neighbours between two phases: a phase keeps reference neighbours of its own only.
// expect: a coupling has no reference neighbours, a phase keeps those of its own only
// expect: ReferenceNeighboursInCoupling<
// expect: Contact, imbibe::give_the_term_to_the_phase_or_use_current_neighbours>
#include "scene.hpp"

struct Glue {
    using neighbourhood = sph::Reference;
    using reads = sph::Fields<sph::mass>;
    using adds = sph::Fields<sph::acceleration>;
    constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
        return along(ab, b[sph::mass] * ab.value(K{}));
    }
};
struct One : sph::Solid<> {};
struct Two : sph::Solid<> {};
struct Contact : sph::Coupling<One, Two, Glue> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, One, Two, Contact>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
