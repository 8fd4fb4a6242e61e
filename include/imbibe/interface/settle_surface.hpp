// Brings the particles at the surface of a liquid with Cohesion to rest before a run begins.
#pragma once

#include <imbibe/core/fields.hpp>
#include <imbibe/interface/cohesion.hpp>

#include <cmath>
#include <limits>

namespace imbibe {

/// Runs a scene for 100 sqrt(rho dx^3/sigma), damping the velocities of `Liquid` at half the inverse of that root, and
/// sets them to zero. The particles at the surface of a liquid with Cohesion find their places, which a lattice does
/// not have: left to themselves they would release 1.5 sigma per area as motion. Drops and levels keep their shape: at
/// 16 spacings a radius they creep by a few per cent of what they would move.
///
/// `settle_surface<Water>(scene);` after all is added, before velocities are given. The scene's time goes on from
/// there; what else moves in it moves.
///
/// @tparam Liquid the fluid @return the scene's time, s; without surface tension nothing is run
template <class Liquid>
double settle_surface(auto& scene) {
    const auto& liquid = scene.template get<Liquid>().material();
    const double sigma = liquid.coefficients.template get<CohesionParameters>().surface_tension;
    if (sigma == 0)
        return scene.time();
    const double root = std::sqrt(liquid.density * power<3>(liquid.spacing) / sigma);
    double before = scene.time();
    scene.run_until(before + 100 * root, [&](auto& s) {
        s.template get<Liquid>()[velocity] *= std::exp(-0.5 * (s.time() - before) / root);
        before = s.time();
    });
    scene.template get<Liquid>()[velocity].setZero();
    return scene.time();
}

} // namespace imbibe
