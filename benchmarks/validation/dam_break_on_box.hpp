// A column of water falls on a box in a tank: the pressure on the box's front.
//
// Reference: the experiment of Kleefsman, Fekken, Veldman, Iwanowski and Buchner (2005), SPHERIC's second test: the
// lowest sensor of the front, P1, shows 10.9 kPa at 0.405 s, right when the water arrives.
// Geometry: tank 3.22 x 1 x 1 m; water 1.228 x 1 x 0.55 m at one end; box 0.161 x 0.403 x 0.161 m, its front 1.1675
// m from the water's. P1 is 0.021 m above the floor, in the middle.
// Scheme: that of the README's dam break in float: Wendland C2 of 2.6 spacings, density diffusion and floor,
// MonaghanViscosity with alpha = 0.02 and beta = 1, walls that do not pull. Sound is ten times sqrt(2 g depth).
// Measure: the force on the part of the front below 0.042 m, or two rows of particles, and within 0.06 m of the middle,
// over its area; with what the water at its foot does to the floor's particles underneath. (The pressure that the
// walls continue from the water is higher while the front of the wave is thinner than the support: it is shown all
// around.) What strikes sets the water before the box ringing with some 100 Hz, twice as high as the experiment's peak;
// so the highest mean over 20 ms is taken, and when the pressure first comes to 1 kPa.
#pragma once

#include "case.hpp"
#include "hydroelastic.hpp"

#include <imbibe/wall/reaction_force.hpp>

#include <deque>

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

    const double high = std::max(2.0, std::round(0.042 / dx)) * dx, wide = 2 * std::floor(0.06 / dx + 0.5) * dx;
    // The force along x on what lies behind the front, within half the width and below the height of that part of it.
    const auto push_on = [&](const auto& body) {
        const auto x = body[sph::position];
        const auto force = body[sph::reaction_force];
        double sum = 0;
        for (int i = 0; i < body.size(); ++i)
            if (x(i, 0) > front && x(i, 0) < front + box_height / 2 && std::abs(x(i, 1) - 0.5) < wide / 2 &&
                x(i, 2) < high)
                sum += force(i, 0);
        return sum;
    };
    Blow blow{0, 0};
    std::deque<std::pair<double, double>> window; // times and pressures of the last 20 ms
    scene.run_until(0.6, [&](const Basin& s) {
        const double pressure = (push_on(s[box]) + push_on(s[tank])) / (high * wide);
        window.emplace_back(s.time(), pressure);
        while (window.front().first < s.time() - 20e-3)
            window.pop_front();
        double mean = 0;
        for (const auto& sample : window)
            mean += sample.second / static_cast<double>(window.size());
        blow.pressure = std::max(blow.pressure, mean);
        if (blow.arrival == 0 && pressure > 1000)
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
