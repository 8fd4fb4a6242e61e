// A column of water falls on a box in a tank: the pressure on the box's front.
//
// Reference: the experiment of Kleefsman, Fekken, Veldman, Iwanowski and Buchner (2005), SPHERIC's second test: the
// lowest sensor of the front, P1, shows 10.9 kPa at 0.405 s, right when the water arrives.
// Geometry: tank 3.22 x 1 x 1 m; water 1.228 x 1 x 0.55 m at one end; box 0.161 x 0.403 x 0.161 m, its front 1.1675
// m from the water's. P1 is 0.021 m above the floor, in the middle.
// Scheme: that of the README's dam break in float: Wendland C2 of 2.6 spacings, density diffusion and floor,
// MonaghanViscosity with alpha = 0.02 and beta = 1, walls that do not pull. Sound is ten times sqrt(2 g depth).
// Measure: a WallGauge on the part of the front below 0.042 m and within 0.06 m of the middle. (The pressure that the
// walls continue from the water is higher while the front of the wave is thinner than the support: it is shown all
// around.) What strikes sets the water before the box ringing with some 100 Hz, twice as high as the experiment's peak;
// so the highest mean over 20 ms is taken, and when the pressure first comes to 1 kPa.
#pragma once

#include "case.hpp"
#include "hydroelastic.hpp"

#include <imbibe/monitor/wall_gauge.hpp>

#include <algorithm>

namespace validation::dam_break_on_box {

using namespace hydroelastic; // the water, the tank and how they push
struct Box : sph::Wall<> {};
template <class Solid>
using Strike = Push<Solid, sph::Into<Solid, sph::ReactionForce<sph::VolumePressure<K>>>>;
using Basin = sph::Solver<3, float, sph::SymplecticEuler, Column, Tank, Box, Strike<Tank>, Strike<Box>>;

struct Blow {
    double pressure; ///< the highest mean, Pa
    double arrival;  ///< when the water is there, s
};

/// @param across particles over the height of the box
inline Blow strike(int across) {
    const double box_height = 0.161, dx = box_height / across, depth = 0.55, front = 1.228 + 1.1675;
    Basin scene({.gravity = {0, 0, -gravity},
                 .support_radius = 2.6 * dx,
                 .cfl = 0.4,
                 .search_interval = 100,
                 .search_skin = 0.1,
                 .threads = 1});
    const sph::PressureExtrapolationParameters no_suction{.suction = false};
    scene.coupling<Strike<Tank>>().set(no_suction);
    scene.coupling<Strike<Box>>().set(no_suction);
    Column water = column(depth);
    water.set(sph::MonaghanViscosityParameters{.alpha = 0.02, .beta = 1});
    scene.add(water, sph::fill(sph::Box<3>{{0, 0, 0}, {1.228, 1, depth}}, dx), dx);
    const auto tank = scene.add(Tank{{.density = 1000}},
                                sph::tank(sph::Box<3>{{0, 0, 0}, {3.22, 1, 1}}, dx, 3, sph::Sides::z_high), dx);
    const auto box = scene.add(
        Box{{.density = 1000}},
        sph::fill(sph::Box<3>{{front, 0.5 - 0.403 / 2, 0}, {front + box_height, 0.5 + 0.403 / 2, box_height}}, dx), dx);

    const sph::WallPatch<3> sensor{{front, 0.44, 0}, {front, 0.56, 0.042}, sph::Sides::x_high};
    sph::WallGauge<3> gauge(sensor, 20e-3);
    Blow blow{0, 0};
    scene.run_until(0.6, [&](const Basin& s) {
        blow.pressure = std::max(blow.pressure, gauge(s, box, tank));
        if (blow.arrival == 0 && sph::patch_pressure(s, sensor, box, tank) > 1000)
            blow.arrival = s.time();
    });
    return blow;
}

inline std::vector<Measured> measure(int across) {
    const Blow blow = strike(across);
    return {{"highest pressure at P1, mean over 20 ms, Pa", "15 %", blow.pressure, 10.9e3},
            {"when the water is there, s", "2 %", blow.arrival, 0.405}};
}

} // namespace validation::dam_break_on_box
