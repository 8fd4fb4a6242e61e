// A column of water runs along a dry floor against a wall (2D): the pressure at four heights of the wall.
//
// Geometry: that of Buchner (2002), with a depth of H = 0.6 m, and of Lobovsky et al. (2014), half as large: column 2 H
// long, tank 5.366 H long, wall 3.366 H from the column. It is run with H = 0.3 m. Pressures are in rho g H, times in
// sqrt(H/g).
// References, means from 3.5 to 4.5, between the first blow and the plunging back of what went up:
// - floor that slips: De Courcy, Rendall, Constantin, Titurus and Cooper (2024), another particle method in 2D,
//   incompressible, at the sensors of Lobovsky et al., 3, 15, 30 and 80 mm above the floor: 1.025, 0.951, 0.841, 0.341
//   (their curves, as the repository trixi-framework/TrixiParticles.jl has them digitised);
// - water in a tank: Buchner's sensor of 90 mm, as digitised there: 0.549. Its middle is said to have been 160 mm above
//   the floor; Greco (2001) found that with its upper edge there computations agree better, and that the measurement is
//   not that certain (after Adami, Hu and Adams 2012, who do the same). Both are given.
//
// Scheme: Wendland C2 of 3 spacings, density diffusion and floor, MonaghanViscosity with alpha = 0.02 and beta = 1,
// walls that do not pull. Sound is ten times sqrt(2 g H).
//
// The floor that sticks: water's own layer is turbulent, Re = U x/nu = 2.1e6 where U = 2.1 m/s has run x = 1 m, and far
// thinner than a spacing. In its place is a laminar one with the same drag on a plate of this length, 1.328
// sqrt(eta/(rho U x)) = 0.074 Re^(-1/5), which gives eta = 0.0193 Pa s; 0.02 is taken. It is some 15 mm thick.
//
// Measure: a WallGauge as large as the sensor, over 0.05 sqrt(H/g).
#pragma once

#include "case.hpp"
#include "free_surface.hpp"

#include <imbibe/fluid/density_floor.hpp>
#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/monitor/wall_gauge.hpp>
#include <imbibe/state/hydrostatic.hpp>
#include <imbibe/wall/no_slip.hpp>

#include <array>

namespace validation::dam_break_at_wall {

using K = sph::WendlandC2;
struct Slipping : Water<K, sph::DensityFloor, sph::MonaghanViscosity<K>> {};
struct Sticking : Water<K, sph::DensityFloor, sph::MonaghanViscosity<K>, sph::MorrisViscosity<K>> {};
struct Tank : sph::Wall<> {};
template <class Liquid, class... More>
struct Push : sph::Coupling<Liquid, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                            sph::Into<Liquid, sph::VolumeContinuity<K>>,
                            sph::Into<Tank, sph::ReactionForce<sph::VolumePressure<K>>>, More...> {};

constexpr double depth = 0.3, gravity = 9.81; // m, m/s^2
/// Where the sensors begin and end, in depths above the floor: four of Lobovsky et al., Buchner's, and that with its
/// upper edge where its middle is said to have been.
constexpr std::array<std::array<double, 2>, 6> sensors{
    {{0.003, 0.017}, {0.043, 0.057}, {0.093, 0.107}, {0.2597, 0.2737}, {0.1917, 0.3417}, {0.1167, 0.2667}}};

/// What a run shows.
struct Shown {
    std::array<double, sensors.size()> mean; ///< from 3.5 to 4.5, rho g H
    double arrival;                          ///< when the water is at the wall, sqrt(H/g)
};

/// @param across particles over the depth @param viscosity Pa s
template <class Liquid, class... More>
Shown run(int across, double viscosity) {
    using Contact = Push<Liquid, More...>;
    using Scene = sph::Solver<2, float, sph::SymplecticEuler, Liquid, Tank, Contact>;
    const double dx = depth / across, length = std::round(5.366 * across) * dx, unit = std::sqrt(depth / gravity);
    Scene scene({.gravity = {0, -gravity},
                 .support_radius = 3 * dx,
                 .cfl = 0.4,
                 .search_interval = 100,
                 .search_skin = 0.1,
                 .threads = 1});
    scene.template coupling<Contact>().set(sph::PressureExtrapolationParameters{.suction = false});
    Liquid water{{.density = 1000, .sound_speed = 10 * std::sqrt(2 * gravity * depth)}};
    if constexpr (requires { water.viscosity; })
        water.viscosity = viscosity;
    water.set(sph::MonaghanViscosityParameters{.alpha = 0.02, .beta = 1});
    const auto column = scene.add(water, sph::fill(sph::Box<2>{{0, 0}, {2 * depth, depth}}, dx), dx);
    const auto tank = scene.add(Tank{{.density = 1000}},
                                sph::tank(sph::Box<2>{{0, 0}, {length, 2.5 * depth}}, dx, 3, sph::Sides::y_high), dx);
    sph::start_hydrostatic(scene, column, depth);

    std::vector<sph::WallGauge<2>> gauges;
    for (const auto& [lower, upper] : sensors)
        gauges.emplace_back(sph::WallPatch<2>{{length, lower * depth}, {length, upper * depth}, sph::Sides::x_high},
                            0.05 * unit);
    Shown shown{};
    double before = 0;
    scene.run_until(4.5 * unit, [&](const Scene& now) {
        const double time = now.time() / unit, step = time > 3.5 && time <= 4.5 ? time - before : 0;
        for (std::size_t k = 0; k < gauges.size(); ++k)
            shown.mean[k] += step * gauges[k](now, tank) / (1000 * gravity * depth);
        const auto x = now[column][sph::position];
        if (shown.arrival == 0 && static_cast<double>(x.col(0).maxCoeff()) > length - dx)
            shown.arrival = time;
        before = time;
    });
    return shown;
}
inline Shown run_slipping(int across) {
    return run<Slipping>(across, 0);
}
inline Shown run_sticking(int across) {
    return run<Sticking, sph::Into<Tank, sph::NoSlipVelocity<K>>, sph::NoSlipViscosity<K>>(across, 0.02);
}

inline std::vector<Measured> measure(int across) {
    const Shown slips = run_slipping(across), sticks = run_sticking(across);
    const char* none = "none given";
    return {{"slipping floor, mean pressure 0.01 H up, rho g H", "5 % at 80", slips.mean[0], 1.025},
            {"slipping floor, 0.05 H up", "5 % at 80", slips.mean[1], 0.951},
            {"slipping floor, 0.1 H up", "5 % at 80", slips.mean[2], 0.841},
            {"slipping floor, 0.267 H up", "5 % at 80", slips.mean[3], 0.341},
            {"slipping floor, Buchner's sensor, 0.267 H up", none, slips.mean[4], 0.549},
            {"slipping floor, Buchner's sensor, 0.192 H up", none, slips.mean[5], 0.549},
            {"sticking floor, Buchner's sensor, 0.267 H up", none, sticks.mean[4], 0.549},
            {"sticking floor, Buchner's sensor, 0.192 H up", "5 % at 80", sticks.mean[5], 0.549},
            {"0.01 H up, sticking over slipping floor", none, sticks.mean[0], slips.mean[0]},
            {"0.05 H up, sticking over slipping floor", none, sticks.mean[1], slips.mean[1]},
            {"0.1 H up, sticking over slipping floor", none, sticks.mean[2], slips.mean[2]},
            {"0.267 H up, sticking over slipping floor", none, sticks.mean[3], slips.mean[3]},
            {"when the water is at the wall, sticking over slipping floor", none, sticks.arrival, slips.arrival}};
}

} // namespace validation::dam_break_at_wall
