// A column of water falls on an elastic baffle on the floor of its tank and bends it.
//
// Reference: Walhorn, Koelke, Huebner and Dinkler (2005), a finite element solution, and the codes that have repeated
// it since: the upper end is 0.045 to 0.05 m aside at 0.24 to 0.26 s.
// Geometry: water 0.146 x 0.292 m in a tank 0.584 m long; baffle 12 x 80 mm, 0.292 m from the wall; 2500 kg/m^3,
// 1e6 Pa, nu = 0; water and baffle have one spacing.
// Scheme: hydroelastic.hpp.
// Measure: the mean of the two uppermost corners' way aside; its peak, and the middle of the time for which it is
// within 5 % of that: the end vibrates while it is there, and which crest is the highest is chance.
#pragma once

#include "case.hpp"
#include "hydroelastic.hpp"

#include <algorithm>

namespace validation::elastic_baffle {

using namespace hydroelastic;

struct Peak {
    double aside; ///< the greatest, m
    double time;  ///< of the middle of the peak, s
};

/// @param across particles over the thickness of the baffle
inline Peak strike(int across) {
    const double thickness = 0.012, height = 0.08, depth = 0.292, spacing = thickness / across;
    Scene scene = scene_of(spacing);
    scene.add(column(depth), sph::fill(sph::Box<2>{{0, 0}, {0.146, depth}}, spacing), spacing);
    const auto baffle =
        scene.add(rubber(1e6, 0, 2500, across, spacing),
                  sph::fill(sph::Box<2>{{0.292, -3 * spacing}, {0.292 + thickness, height}}, spacing), spacing);
    scene.hold(baffle, [](const auto& x) { return x[1] < 0; });
    auto walls = sph::tank(sph::Box<2>{{0, 0}, {0.584, 1.5 * depth}}, spacing, 3, sph::Sides::y_high);
    std::erase_if(walls, [&](const auto& x) { // there the root of the baffle is
        return x[1] < 0 && x[0] > 0.292 - 0.6 * spacing && x[0] < 0.292 + thickness + 0.6 * spacing;
    });
    scene.add(Tank{{.density = 1000}}, walls, spacing);

    std::vector<Peak> way; // after every step
    scene.run_until(0.35, [&](const Scene& s) {
        const auto view = s[baffle];
        const auto x = view[sph::position], X = view[sph::reference_position];
        double aside = 0;
        for (int i = 0; i < view.size(); ++i)
            if (X(i, 1) > height - spacing)
                aside += (x(i, 0) - X(i, 0)) / across;
        way.push_back({aside, s.time()});
    });
    const double most =
        std::max_element(way.begin(), way.end(), [](const Peak& a, const Peak& b) { return a.aside < b.aside; })->aside;
    const auto is_near = [&](const Peak& one) { return one.aside > 0.95 * most; };
    const auto first = std::find_if(way.begin(), way.end(), is_near);
    const auto last = std::find_if(way.rbegin(), way.rend(), is_near);
    return {most, 0.5 * (first->time + last->time)};
}

inline std::vector<Measured> measure(int across) {
    const Peak peak = strike(across);
    return {{"way of the upper end, m", "5 % (the spread)", peak.aside, 0.0475},
            {"time of the peak, s", "4 % (the spread)", peak.time, 0.25}};
}

} // namespace validation::elastic_baffle
