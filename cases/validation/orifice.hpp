// Water runs out of a tank through a slot in its floor.
//
// Reference: the jet contracts to pi/(pi + 2) = 0.611 of the slot's width under a deep tank with a thin floor
// (Kirchhoff 1869; the discharge coefficient of sharp orifices in experiments is 0.61 too).
// Geometry: plane; slot 0.1 m wide, in the middle of a floor 1 m wide and three layers of particles thick, whose
// edges fall away from the slot with 45 degrees below the first layer; 1 m of water. What has fallen 0.3 m below the
// floor is taken out.
// Scheme: hydroelastic.hpp without its rubber: Wendland C2 of 2.6 spacings, density diffusion and floor, walls
// that do not pull.
// Measure: while the surface sinks from 0.9 to 0.6 m, the water that has left over the slot's width times the
// integral of sqrt(2 g h), with h the mean height of the water that is left.
#pragma once

#include "case.hpp"
#include "hydroelastic.hpp"

#include <numbers>

namespace validation::orifice {

using namespace hydroelastic;
using Tub = sph::Solver<2, double, sph::SymplecticEuler, Column, Tank, Push<Tank>>;

/// The discharge coefficient. @param across particles over the slot's width
inline double discharge(int across) {
    const double slot = 0.1, width = 1, depth = 1, dx = slot / across;
    Tub scene({.gravity = {0, -gravity}, .support_radius = 2.6 * dx, .cfl = 0.4, .search_interval = 4, .threads = 1});
    scene.coupling<Push<Tank>>().set(sph::PressureExtrapolationParameters{.suction = false});
    const auto pool = scene.add(column(depth), sph::fill(sph::Box<2>{{0, 0}, {width, depth}}, dx), dx);
    auto walls = sph::tank(sph::Box<2>{{0, 0}, {width, depth}}, dx, 3, sph::Sides::y_high);
    std::erase_if(walls, [&](const auto& x) {
        const double away = std::abs(x[0] - width / 2) - slot / 2; // behind the slot's edge
        return x[1] < 0 && away < -x[1] - dx / 2;
    });
    scene.add(Tank{{.density = 1000}}, walls, dx);

    double left = 0, first = 0, last = 0, integral = 0, before = 0; // m^2, m^2, m^2, m^1.5 s^0.5, s
    bool over = false;
    while (!over) {
        scene.step();
        scene.remove_if(pool, [&](const auto& x) { return x[1] < -0.3; });
        const auto view = scene[pool];
        const auto x = view[sph::position];
        int above = 0;
        for (int i = 0; i < view.size(); ++i)
            above += x(i, 1) > 0 ? 1 : 0;
        left = above * dx * dx;
        const double height = left / width, now = scene.time();
        sph::require(now < 20, "orifice: after 20 s of run time the surface still stands at ", height, " m");
        if (height <= 0.9 && height > 0.6) {
            if (first == 0)
                first = left;
            else
                integral += std::sqrt(2 * gravity * height) * (now - before);
            last = left;
        }
        before = now;
        over = height <= 0.6;
    }
    return (first - last) / (slot * integral);
}

inline std::vector<Measured> measure(int across) {
    return {{"discharge coefficient", "5 %", discharge(across), std::numbers::pi / (std::numbers::pi + 2)}};
}

} // namespace validation::orifice
