// The paper's sponge on one row of pores, under 14 mm of water, and what is watched while it runs.
#pragma once

#include <imbibe/imbibe.hpp>
#include <imbibe/presets/sponge.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace validation::sponge_strip {

namespace sph = imbibe;
using sph::presets::SpongeCase;

/// The scene with pores of that radius, m.
inline SpongeCase strip(double pore_radius) {
    SpongeCase c;
    c.pore_radius = pore_radius;
    c.strip = true;
    c.pool = 14e-3;
    c.water_spacing = 0.7e-3; // ten to the period of 7 mm
    return c;
}

/// The share of the water particles nearer than half a spacing to a particle of the other phase, or, where that is the
/// water, to another one of their own. Pairs across the periodic sides are not seen.
template <class Water, class Other>
double share_near(const Water& water, const Other& other, const SpongeCase& c) {
    const double near = c.water_spacing / 2;
    std::map<std::array<int, 3>, std::vector<int>> cells;
    const auto cell = [&](const auto& x, int i) {
        return std::array<int, 3>{int(std::floor(x(i, 0) / near)), int(std::floor(x(i, 1) / near)),
                                  int(std::floor(x(i, 2) / near))};
    };
    const auto x = other[sph::position];
    for (int i = 0; i < other.size(); ++i)
        cells[cell(x, i)].push_back(i);
    const auto w = water[sph::position];
    const bool itself = x.data() == w.data();
    int inside = 0;
    for (int i = 0; i < water.size(); ++i) {
        const auto at = cell(w, i);
        bool found = false;
        for (int k = 0; k < 27 && !found; ++k) {
            const auto there = cells.find({at[0] + k % 3 - 1, at[1] + k / 3 % 3 - 1, at[2] + k / 9 - 1});
            if (there != cells.end())
                found = std::any_of(there->second.begin(), there->second.end(),
                                    [&](int j) { return !(itself && i == j) && (x.row(j) - w.row(i)).norm() < near; });
        }
        inside += found;
    }
    return double(inside) / water.size();
}

/// What is watched during a run.
struct Seen {
    std::vector<double> times, displacement, drained; ///< s, m, share of the water
    double peak = 0, late_mean = 0;                   ///< m; the first peak, and the mean over the last 40 %
    double off_density = 0; ///< the greatest share of the water, at any moment, off by over 2 % in density
    double off_later = 0;   ///< the same from 30 ms after the impact on
    double lightest = 1e300, densest = 0; ///< of all particles of the water at any moment, kg/m^3
    double in_the_sponge = 0;             ///< the greatest share nearer than half a spacing to the sponge
    double in_pairs = 0;                  ///< the greatest share nearer than that to another particle of the water
    double beyond_the_walls = 0; ///< how far water was behind the face of a wall, m; a drop over its rim is not
    int lost = 0;                         ///< particles neither in the scene nor drained
};

/// Runs a composition of presets/sponge.hpp to `end`, s.
template <class Composition>
Seen run(const SpongeCase& c, double end) {
    using Water = typename Composition::Water;
    auto scene = Composition::template make<float>(c);
    const auto water = scene.template get<Water>();
    const auto sponge = scene.template get<typename Composition::Sponge>();
    const sph::DisplacementProbe<3> probe(sponge);
    const double rim = scene.template get<typename Composition::Vessel>()[sph::position].col(2).maxCoeff();
    const int start = water.size();
    int left = 0, late = 0;
    Seen seen;
    scene.run_until(
        end,
        [&](auto& s) {
            if (s.steps() % 20 == 0)
                left += s.remove_if(sph::PhaseHandle<Water>{}, [&](const auto& x) { return x[2] < -c.drain; });
        },
        sph::every(2.5e-3, [&](const auto& s) {
            const auto x = water[sph::position];
            const auto rho = water[sph::density];
            int below = left, off = 0;
            for (int i = 0; i < water.size(); ++i) {
                below += x(i, 2) < 0;
                off += std::abs(double(rho(i)) / 1000 - 1) > 0.02;
                if (x(i, 2) > -c.drain + 2 * c.water_spacing && x(i, 2) < rim) // below, the water leaves
                    seen.beyond_the_walls =
                        std::max({seen.beyond_the_walls, -double(x(i, 0)), double(x(i, 0)) - c.length()});
            }
            const double mean = probe.mean(sponge);
            seen.times.push_back(s.time());
            seen.displacement.push_back(mean);
            seen.drained.push_back(double(below) / start);
            seen.off_density = std::max(seen.off_density, double(off) / water.size());
            if (s.time() > 60e-3)
                seen.off_later = std::max(seen.off_later, double(off) / water.size());
            seen.lightest = std::min(seen.lightest, double(rho.minCoeff()));
            seen.densest = std::max(seen.densest, double(rho.maxCoeff()));
            seen.in_the_sponge = std::max(seen.in_the_sponge, share_near(water, sponge, c));
            seen.in_pairs = std::max(seen.in_pairs, share_near(water, water, c));
            if (s.time() < 0.055)
                seen.peak = std::max(seen.peak, mean);
            if (s.time() > 0.6 * end) {
                seen.late_mean += mean;
                ++late;
            }
        }));
    seen.late_mean /= std::max(late, 1);
    seen.lost = start - left - water.size();
    return seen;
}

} // namespace validation::sponge_strip
