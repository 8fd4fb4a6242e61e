// Creeping flow through a square array of cylinders of fitted particles, by what counts the mass at their surfaces.
//
// Reference: that of cylinders.hpp (Sangani and Acrivos 1982), F/(mu U) for solid fractions c.
// Geometry: one periodic cell of side 1 with the cylinder in its middle; liquid and cylinder are packed together by
// fitted_together(). Scheme: that of porous/permeability.hpp in double, with NoSlipContinuity, or with VolumeContinuity
// in its place; nu is 1 and sound 100, H/dx = 3. Measure: F/(mu U) = f/U, once U has stopped growing.
#pragma once

#include "cylinders.hpp"

#include <imbibe/geometry/combine.hpp>
#include <imbibe/geometry/fitted.hpp>
#include <imbibe/geometry/sphere.hpp>
#include <imbibe/porous/permeability.hpp>

namespace validation::fitted_cylinders {

namespace sph = imbibe;
using K = sph::QuinticSpline;
using Liquid = sph::porous::Liquid;
using Grains = sph::porous::Grains;

/// sph::porous::Contact, but for the wall's own velocity in the continuity equation.
struct OwnVelocity : sph::Coupling<Liquid, Grains, sph::Into<Grains, sph::PressureExtrapolation<K>>,
                                   sph::VolumePressure<K>, sph::Into<Liquid, sph::VolumeContinuity<K>>,
                                   sph::Into<Grains, sph::NoSlipVelocity<K>>, sph::NoSlipViscosity<K>> {};

/// F/(mu U).
template <class Contact = sph::porous::Contact>
double drag(int across, double fraction) {
    const double spacing = 1.0 / across, force = 0.1;
    const sph::Box<2> cell{{0, 0}, {1, 1}};
    const sph::Sphere<2> disc{{0.5, 0.5}, std::sqrt(fraction / std::numbers::pi)};
    const auto parts = sph::fitted_together(spacing, cell.lower(), 0, disc, cell - disc);
    sph::Solver<2, double, sph::SymplecticEuler, Liquid, Grains, Contact> scene(
        {.gravity = {force, 0}, .support_radius = 3 * spacing, .cfl = 0.4, .periodic_length = {1, 1}, .threads = 1});
    const auto liquid = scene.add(Liquid{{.density = 1, .sound_speed = 100, .viscosity = 1}}, parts[1], spacing);
    scene.add(Grains{{.density = 1}}, parts[0], spacing);
    for (double U = 0, before = -1;; before = U) {
        scene.run_until(scene.time() + 0.02);
        U = scene[liquid][sph::velocity].col(0).sum() * spacing * spacing;
        if (U > 0 && std::abs(U - before) < 3e-4 * U)
            return force / U;
    }
}

inline std::vector<Measured> measure(int across) {
    std::vector<Measured> found;
    for (const auto& a : cylinders::known) {
        found.push_back({sph::text("F/(mu U), ", a.name), "2 % at 25", drag(across, a.fraction), a.drag});
        found.push_back({sph::text("F/(mu U), ", a.name, ", VolumeContinuity"), "none given",
                         drag<OwnVelocity>(across, a.fraction), a.drag});
    }
    return found;
}

} // namespace validation::fitted_cylinders
