// The start of a flow in a round pipe, driven by a body force.
//
// Reference: the series solution, velocity on the axis over the one it comes to, f R^2/(4 nu), at five times.
// Geometry: R and nu are 1; 8 spacings long and periodic, cubic lattice, whose points within R of the axis are liquid
// and those round it the wall. Where the axis lies between the lattice's points is chosen so that the liquid takes its
// share of them.
// Scheme: that of creeping.hpp; sound is 40 nu/R, 160 times the greatest speed.
// Measure: u on the axis, that of the parabola in r^2 that fits the inner half of the radius best.
#pragma once

#include "creeping.hpp"

#include <Eigen/Cholesky>

#include <array>
#include <numbers>

namespace validation::pipe {

constexpr std::array<double, 5> times{0.05, 0.1, 0.2, 0.5, 1}; // of R^2/nu
constexpr std::array<double, 5> known{.19962, .38519, .65180, .93852, .99659};

/// u on the axis over f R^2/(4 nu) at `times`. @param across spacings in a diameter, @param support in spacings
template <class K = sph::QuinticSpline, class Real = double>
std::array<double, 5> axis_velocities(int across, double support = 3) {
    const double spacing = 2.0 / across, length = 8 * spacing, force = 1;
    const int half = across / 2 + static_cast<int>(std::ceil(support)) + 1; // of the lattice across, wall included
    const double side = half * spacing;
    const auto distance = [](const auto& x) { return std::hypot(x[1], x[2]); };
    const auto lattice = sph::fill(sph::Box<3>{{0, -side, -side}, {length, side, side}}, spacing);
    // The liquid's share is chosen, so the liquid stands where an obstacle would.
    auto parts = creeping::part<3>(lattice, spacing, {0, 0, 0}, std::numbers::pi * length,
                                   [&](const auto& x) { return distance(x) < 1; });
    std::swap(parts.liquid, parts.obstacle);
    sph::Point<3> axis = sph::Point<3>::Zero();
    for (const auto& x : parts.liquid)
        axis += x / static_cast<double>(parts.liquid.size());
    std::erase_if(parts.obstacle, [&](const auto& x) {
        return distance(sph::Point<3>(x - axis)) > 1 + (support + 0.5) * spacing;
    });
    auto scene = creeping::scene_of<K, Real, 3>(parts, {length, 0, 0}, {force, 0, 0}, spacing, support, 40);

    std::array<double, 5> middle{};
    for (std::size_t k = 0; k < times.size(); ++k) {
        scene.run_until(times[k]);
        const auto liquid = scene[sph::PhaseHandle<creeping::Liquid<K>>{}];
        Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
        Eigen::Vector3d sums = Eigen::Vector3d::Zero();
        for (int i = 0; i < liquid.size(); ++i) {
            const double r = std::hypot(liquid[sph::position](i, 1) - axis[1], liquid[sph::position](i, 2) - axis[2]);
            if (r < 0.5) {
                const Eigen::Vector3d powers{1, r * r, r * r * r * r};
                moments += powers * powers.transpose();
                sums += liquid[sph::velocity](i, 0) * powers;
            }
        }
        middle[k] = moments.ldlt().solve(sums)(0) / (force / 4);
    }
    return middle;
}

inline std::vector<Measured> measure(int across) {
    const auto middle = axis_velocities(across);
    std::vector<Measured> found;
    for (std::size_t k = 0; k < times.size(); ++k)
        found.push_back({sph::text("u/u_max on the axis at nu t/R^2 = ", times[k]), "2 %", middle[k], known[k]});
    return found;
}

} // namespace validation::pipe
