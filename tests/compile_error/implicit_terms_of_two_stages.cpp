// An implicit drag with an integrator that evaluates all terms twice a step.
// expect: ImplicitTermsNotAllowed<imbibe::MidpointRungeKutta, Water
// expect: take_one_that_allows_implicit_such_as_SymplecticEuler
#include "scene.hpp"

#include <imbibe/heat/conduction.hpp>
#include <imbibe/heat/enthalpy_porosity.hpp>
#include <imbibe/heat/melting.hpp>
#include <imbibe/time/midpoint_runge_kutta.hpp>

struct Water : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>, sph::Melting,
                          sph::HeatConduction<K>, sph::EnthalpyPorosity> {};
using Scene = sph::Solver<2, double, sph::MidpointRungeKutta, Water>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.step();
}
