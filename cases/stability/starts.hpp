// Particles that are wrong from the start, or too fast for their lists of neighbours: too near each other, too few, and
// projectiles. Rows 11, 12 and 22 of the gauntlet.
#pragma once

#include "coupled.hpp"

namespace stability {

/// The greatest speed in a phase, m/s.
template <class View>
double greatest_speed(const View& phase) {
    return std::sqrt(static_cast<double>(phase[sph::velocity].rowwise().squaredNorm().maxCoeff()));
}

/// A block of water at rest, compressed by a hundredth, whose columns stand in pairs, `value` spacings apart. Row 11.
/// (Points nearer than 1e-3 spacings are refused.)
template <class F, class Real = double>
Outcome columns_in_pairs(const Plan& plan) {
    const double c = 30;
    auto scene = fluid_scene<F, Real>(0, c);
    auto points = sph::fill(sph::Box<2>{{0, 0}, {12 * dx, 12 * dx}}, dx);
    for (auto& x : points)
        if (std::lround(std::floor(x[0] / dx)) % 2 == 1)
            x[0] -= (1 - plan.value) * dx;
    const auto water = add_water<F>(scene, points, c);
    scene[water][sph::density].setConstant(1010);
    const Watch<2> watch{.end = 200 * dx / c,
                         .guard = {.energy = std::numeric_limits<double>::infinity()},
                         .signs = {{"greatest speed over that of sound", 0.1}},
                         .expected_steps = 200};
    return march(scene, plan, watch, [&](const auto& s) { return std::vector{greatest_speed(s[water]) / c}; });
}

/// A block of water at rest that starts `value` spacings deep in an elastic block. Row 11: phases may be laid over each
/// other; a scene warns of pairs that are near.
template <class C, class Real = double>
Outcome water_in_solid(const Plan& plan) {
    const double c = 30;
    auto scene = coupled_scene<C, Real>(c);
    add_body<C>(scene, sph::fill(sph::Box<2>{{0, -8 * dx}, {12 * dx, 0}}, dx), 1e6, 0.3, 950);
    auto points = sph::fill(sph::Box<2>{{2 * dx, 0}, {10 * dx, 8 * dx}}, dx);
    for (auto& x : points)
        x += sph::Point<2>(0.3, C::gap - plan.value) * dx;
    const auto water = add_water<typename C::Fluid>(scene, points, c);
    const Watch<2> watch{.end = 200 * dx / c,
                         .guard = {.energy = std::numeric_limits<double>::infinity()},
                         .signs = {{"greatest speed over that of sound", 0.1}},
                         .expected_steps = 200};
    return march(scene, plan, watch, [&](const auto& s) { return std::vector{greatest_speed(s[water]) / c}; });
}

/// The gradient of the coordinate x inside a lattice, as the kernel's sums have it: 1 would be right. Row 12.
/// @param support H in spacings
template <class K, int dim>
double gradient_of_x(double support) {
    struct Probe : sph::Solid<sph::ReferenceCorrection<K>> {};
    sph::Solver<dim, double, sph::SymplecticEuler, Probe> scene({.support_radius = support * dx, .threads = 1});
    const sph::Point<dim> corner = sph::Point<dim>::Constant(4.5 * dx); // 9 particles across, one in the middle
    const auto body = scene.add(elastic<Probe>(young, 0.3, rho), sph::fill(sph::Box<dim>(-corner, corner), dx), dx);
    scene.prepare();
    Eigen::Index middle = 0;
    scene[body][sph::position].rowwise().squaredNorm().minCoeff(&middle);
    return scene[body][sph::moment_matrix](middle, 0);
}

/// How many particles of the same phase are nearer than so many hundredths of a support.
struct NearCount : sph::Field<sph::Rank::scalar> {
    static constexpr std::string_view name = "near_count", unit = "1";
};
template <int percent>
struct CountNear {
    using reads = sph::Fields<>;
    using adds = sph::Fields<NearCount{}>;
    constexpr auto operator()(const auto&, const auto&, const auto& ab) const {
        using T = std::remove_cvref_t<decltype(ab.distance)>;
        return sph::select(ab.q() < T(0.01 * percent), sph::select(ab.q() > T(1e-9), T(1), T(0)), T(0));
    }
};
template <int percent>
struct Swarm : sph::Fluid<CountNear<percent>> {};

/// A swarm of particles that fly past each other, the fastest by `value` supports in a step, with neighbours that may
/// serve a thousand steps. Pairs nearer than `percent` hundredths of a support that the lists do not have are counted:
/// up to 90, what Settings::search_interval promises, there must be none. Row 22.
template <int percent = 90>
Outcome fast_swarm(const Plan& plan) {
    constexpr int across = 12;
    constexpr double H = 2.6 * dx, length = across * dx, dt = 1e-3;
    sph::Solver<2, double, sph::SymplecticEuler, Swarm<percent>> scene(
        {.support_radius = H, .periodic_length = {length, length}, .search_interval = 1000, .threads = 1});
    const auto swarm = scene.add(Swarm<percent>{{.density = 1000, .sound_speed = 30}},
                                 sph::jitter<2>(sph::fill(sph::Box<2>{{0, 0}, {length, length}}, dx), 0.3 * dx, 5), dx);
    shake(scene[swarm], plan.value * H / dt / std::sqrt(2.0));
    Outcome out;
    out.signs = {{"pairs that were missed", 0.5}};
    const auto within_period = [](double x) { return x - length * std::round(x / length); };
    for (int step = 0; step < 100 && out.stable; ++step) {
        const Eigen::MatrixXd x = scene[swarm][sph::position];
        long near = 0, seen = 0; // forces, and this count, are those at the beginning of the step
        for (Eigen::Index i = 0; i < x.rows(); ++i)
            for (Eigen::Index j = 0; j < x.rows(); ++j)
                near += i != j && std::hypot(within_period(x(i, 0) - x(j, 0)), within_period(x(i, 1) - x(j, 1))) <
                                      0.01 * percent * H * (1 - 1e-9);
        scene.step(dt);
        seen = std::lround(scene[swarm][NearCount{}].sum());
        out.signs[0].worst = std::max(out.signs[0].worst, static_cast<double>(near - seen));
        out.stable = out.signs[0].worst <= out.signs[0].bound;
    }
    if (!out.stable)
        out.cause = out.signs[0].name;
    out.steps = scene.steps();
    return out;
}

} // namespace stability
