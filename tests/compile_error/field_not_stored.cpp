// A look at a field that no term of the phase uses.
// expect: FieldNotStored
// expect: no term of this phase uses this field, so it is not stored
// expect: DeviatoricStress
// expect: Water, imbibe::list_a_term_that_uses_it_or_look_at_another>
#include "scene.hpp"

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    const auto water = scene.add(Water{{.density = 1000, .sound_speed = 10}}, {}, 0.05);
    return static_cast<int>(scene[water][sph::deviatoric_stress].sum());
}
