// An impact of a drop on an elastic block, seen from frames that are moved, boosted, turned, mirrored or far away, and
// with its particles in another order: it must be the same. Rows 15 and 23 of the gauntlet.
#pragma once

#include "coupled.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace stability {

constexpr int steps_in_a_frame = 200;

/// A frame: x' = turn x + offset + boost t, particles added in another order.
struct Frame {
    Eigen::Matrix2d turn = Eigen::Matrix2d::Identity();
    Eigen::RowVector2d offset = Eigen::RowVector2d::Zero(), boost = Eigen::RowVector2d::Zero();
    bool reversed = false;
    std::array<double, 2> origin{};
};

/// Drop and elastic block, not symmetric about anything, that meet with 1 m/s under gravity. Returns positions and
/// velocities, seen from the first frame.
template <class Real = double, class C = SoundCoupling>
Eigen::MatrixXd meet(const Frame& frame) {
    using Of = typename C::Fluid;
    const Eigen::RowVector2d down = Eigen::RowVector2d(0.3 * g, -g) * frame.turn.transpose();
    CoupledScene<C, Real> scene({.gravity = {down[0], down[1]},
                                 .support_radius = Of::support * dx,
                                 .time_step = 4e-6,
                                 .origin = frame.origin,
                                 .threads = 1});
    C::set(scene.template coupling<typename C::Contact>(), water_of<Of>(30));
    const auto placed = [&](double x, double y, double wide, double high) {
        std::vector<sph::Point<2>> points =
            sph::fill(sph::Box<2>{{x * dx, y * dx}, {(x + wide) * dx, (y + high) * dx}}, dx);
        for (auto& p : points)
            p = frame.turn * p + frame.offset.transpose();
        if (frame.reversed)
            std::reverse(points.begin(), points.end());
        return points;
    };
    const auto water = add_water<Of>(scene, placed(0.3, 1, 7, 6), 30);
    const auto block = add_body<C>(scene, placed(-2, -5, 9, 5), 1e6, 0.3, 950);
    const Eigen::RowVector2d thrown = Eigen::RowVector2d(0.4, -1) * frame.turn.transpose();
    auto w = scene[water];
    auto b = scene[block];
    for (int i = 0; i < w.size(); ++i)
        w[sph::velocity].row(i) = (thrown + frame.boost).template cast<Real>();
    for (int i = 0; i < b.size(); ++i)
        b[sph::velocity].row(i) = frame.boost.template cast<Real>();
    for (int k = 0; k < steps_in_a_frame; ++k)
        scene.step();
    Eigen::MatrixXd seen(w.size() + b.size(), 4);
    const auto put = [&](const auto& phase, int first) {
        const Eigen::RowVector2d here =
            frame.offset + frame.boost * scene.time() - Eigen::RowVector2d(frame.origin[0], frame.origin[1]);
        for (int i = 0; i < phase.size(); ++i) {
            int id = static_cast<int>(phase.ids()[static_cast<std::size_t>(i)]);
            if (frame.reversed)
                id = phase.size() - 1 - id;
            // turn^-1 = turn^T, and rows are transposed
            seen.block(first + id, 0, 1, 2) =
                (phase[sph::position].row(i).template cast<double>() - here) * frame.turn / dx;
            seen.block(first + id, 2, 1, 2) =
                (phase[sph::velocity].row(i).template cast<double>() - frame.boost) * frame.turn;
        }
    };
    put(w, 0);
    put(b, w.size());
    return seen; // positions in spacings, velocities in m/s, which is that of the impact
}
inline double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    return (a - b).cwiseAbs().maxCoeff();
}

/// A frame in which an impact must be what it is at home, but for round-off.
struct NamedFrame {
    std::string name;
    Frame frame;
    double tolerance; ///< how far off it may be, in units of `round_off`
};
/// Round-off times steps: an error of epsilon in an offset of a spacing is one of c dt/dx epsilon in the velocity of
/// sound a step, and 30 m/s are 30 of the units that `meet` returns.
inline constexpr double round_off = std::numeric_limits<double>::epsilon() * steps_in_a_frame * 30;

inline std::vector<NamedFrame> frames() {
    const auto turned = [](double a, double b, double c, double d) {
        Frame frame;
        frame.turn << a, b, c, d;
        return frame;
    };
    const double far = 16 * dx; // coordinates lose 4 bits
    return {{"turned by 90 degrees", turned(0, -1, 1, 0), 1},
            {"mirrored", turned(-1, 0, 0, 1), 1},
            {"turned by 0.7", turned(std::cos(0.7), -std::sin(0.7), std::sin(0.7), std::cos(0.7)), 10},
            {"16 spacings away", {.offset = {far, -far}}, 16},
            {"boosted", {.boost = {3, 2}}, 16},
            {"in another order", {.reversed = true}, 1}};
}
/// Ten thousand times as far as the scene is high, m: in float that takes `Settings::origin`.
inline constexpr double far_away = 1e4 * 12 * dx;

} // namespace stability
