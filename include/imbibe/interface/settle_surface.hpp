// Brings the particles at the surface of a liquid with Cohesion to rest before a run begins.
#pragma once

#include <imbibe/core/fields.hpp>
#include <imbibe/interface/cohesion.hpp>

#include <cmath>
#include <type_traits>

namespace imbibe {

/// Runs a scene for 40 t, with t = sqrt(rho dx^3/sigma), damping the velocities of `Liquid` at the rate 2/t, and sets
/// them to zero. The particles at the surface of a liquid with Cohesion find their places, which a lattice does not
/// have: left to themselves they would release 1.5 sigma per area as motion.
///
/// Shapes creep meanwhile: the difference of an ellipse from a disc of radius R falls by 120 (dx/R)^3 of itself, 3 % at
/// 16 spacings a radius, that of an ellipsoid from a ball by a third more.
///
/// Call it after all particles were added and before velocities are given: `settle_surface<Water>(scene);`. The scene's
/// time goes on from there; what else moves in it moves.
///
/// @tparam Liquid the fluid @return the scene's time, s; without surface tension nothing is run
template <class Liquid>
double settle_surface(auto& scene) {
    const auto& liquid = scene.template get<Liquid>().material();
    const double sigma = liquid.coefficients.template get<CohesionParameters>().surface_tension;
    if (sigma == 0)
        return scene.time();
    const double t = std::sqrt(liquid.density * power<3>(liquid.spacing) / sigma);
    double before = scene.time();
    scene.run_until(before + 40 * t, [&](auto& s) {
        auto v = s.template get<Liquid>()[velocity];
        v *= static_cast<typename std::decay_t<decltype(v)>::Scalar>(std::exp(-2 * (s.time() - before) / t));
        before = s.time();
    });
    scene.template get<Liquid>()[velocity].setZero();
    return scene.time();
}

} // namespace imbibe
