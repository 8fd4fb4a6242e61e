// A block of water that slips down a ramp: how much the ramp brakes it, by how its particles were placed.
//
// Reference: g sin(a) t, without friction.
// Geometry: water 0.2 m x 0.05 m on a ramp of four layers, at the angle a; both by fitted(), in their own frames, or
// the ramp by fill(), which makes stairs of it. Scheme: weakly compressible, MonaghanViscosity inside, free-slip wall
// without suction, H/dx = 2.6. Measure: the mean velocity along the ramp after 0.5 s.
#pragma once

#include "case.hpp"

#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/geometry/fitted.hpp>
#include <imbibe/methods/weakly_compressible.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <numbers>

namespace validation::ramp {

namespace sph = imbibe;

struct Water : sph::Fluid<sph::LinearState, sph::WeaklyCompressible<>, sph::MonaghanViscosity<sph::WendlandC2>> {};
struct Ramp : sph::Wall<> {};
struct Contact : sph::CouplingOf<Water, Ramp> {};

/// The velocity over g sin(a) t. @param across particles over the water's depth @param stairs the ramp by fill()
inline double speed(double degrees, int across, bool stairs) {
    const double dx = 0.05 / across, g = 9.81, end = 0.5, angle = -degrees * std::numbers::pi / 180;
    const auto block = sph::rotated(sph::Box<2>({0, 0}, {0.2, 0.05}), angle);
    const auto slope = sph::rotated(sph::Box<2>({-0.5, -4 * dx}, {1.6, 0}), angle);
    sph::Solver<2, double, sph::SymplecticEuler, Water, Ramp, Contact> scene(
        {.gravity = {0, -g}, .support_radius = 2.6 * dx, .cfl = 0.4, .threads = 1, .on_warning = {}});
    const auto water = scene.add(Water{{.density = 1000, .sound_speed = 30}},
                                 stairs ? sph::fill(block, dx, {0, 0}) : sph::fitted(block, dx), dx);
    scene.add(Ramp{{.density = 1000}}, stairs ? sph::fill(slope, dx, {0, 0}) : sph::fitted(slope, dx), dx);
    scene.coupling<Contact>().set(sph::PressureExtrapolationParameters{.suction = false});
    scene.run_until(end);
    const Eigen::RowVector2d mean = scene[water][sph::velocity].colwise().mean();
    return (mean[0] * std::cos(angle) + mean[1] * std::sin(angle)) / (g * std::sin(-angle) * end);
}

inline std::vector<Measured> measure(int across) {
    std::vector<Measured> found;
    for (const double degrees : {3.0, 10.0, 20.0})
        found.push_back({sph::text("speed at ", degrees, " degrees, fitted"), "2 %", speed(degrees, across, false), 1});
    found.push_back({"at 10 degrees, fill()", "none given", speed(10, across, true), 1});
    return found;
}

} // namespace validation::ramp
