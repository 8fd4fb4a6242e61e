// Two metres of water on an aluminium plate that is clamped at both ends: how far its middle hangs down.
//
// Reference: Fourey et al. (2017): two-dimensional elasticity gives 7.065e-5 m, the theory of thin beams 6.860e-5 m.
// Geometry: 1 m wide, the plate 0.05 m thick; 2700 kg/m^3, 67.5e9 Pa, nu = 0.34; water and plate have one spacing.
// Scheme: hydroelastic.hpp; its sub-cycling gives the metal, whose sound is a hundred times as fast as the
// water's, some two hundred steps in each of the water's. The water starts with the pressure of its weight.
// Measure: the mean sag of the two columns in the middle over the last tenth of 0.3 s; water and plate are damped,
// each about critically, until then.
#pragma once

#include "case.hpp"
#include "hydroelastic.hpp"

#include <imbibe/monitor/displacement.hpp>

namespace validation::stiff_plate {

using namespace hydroelastic;

/// How far the middle hangs down, m. @param across particles over the thickness of the plate
inline double sag(int across) {
    const double depth = 2, thickness = 0.05, dx = thickness / across, end = 0.3;
    const double damping_of_water = 100, damping_of_plate = 650; // 1/s
    Scene scene = scene_of(dx);
    const Column water = column(depth);
    const auto pool = scene[scene.add(water, sph::fill(sph::Box<2>{{0, 0}, {1, depth}}, dx), dx)];
    for (int i = 0; i < pool.size(); ++i) // the mass that goes with the pressure, too: neighbours stay where they are
        pool[sph::density](i) += 1000 * gravity * (depth - pool[sph::position](i, 1)) / sph::sq(water.sound_speed);
    const auto plate = scene.add(rubber(67.5e9, 0.34, 2700, across, dx),
                                 sph::fill(sph::Box<2>{{-4 * dx, -thickness}, {1 + 4 * dx, 0}}, dx), dx);
    scene.hold(plate, [](const auto& x) { return x[0] < 0 || x[0] > 1; });
    auto sides = sph::fill(sph::Box<2>{{-3 * dx, 0}, {0, 1.1 * depth}}, dx);
    for (const auto& x : sph::fill(sph::Box<2>{{1, 0}, {1 + 3 * dx, 1.1 * depth}}, dx))
        sides.push_back(x);
    scene.add(Tank{{.density = 1000}}, sides, dx);

    const sph::DisplacementProbe<2> probe(scene[plate]);
    double sum = 0, before = 0;
    scene.run_until(end, [&](Scene& s) {
        const double dt = s.time() - before;
        before = s.time();
        pool[sph::velocity] *= std::exp(-damping_of_water * dt);
        s[plate][sph::velocity] *= std::exp(-damping_of_plate * dt);
        if (s.time() > 0.9 * end)
            sum -= dt * probe.mean_vector(s[plate], [&](const auto& x) { return std::abs(x[0] - 0.5) < dx; })[1];
    });
    return sum / (0.1 * end);
}

inline std::vector<Measured> measure(int across) {
    return {{"sag, m", "2 %", sag(across), 7.065e-5}};
}

} // namespace validation::stiff_plate
