// What is only one particle thick: walls under water, sheets and threads of a solid, threads and drops of a fluid, and
// floors with slots in them. Rows 4, 10 and 17 of the gauntlet.
#pragma once

#include "fluids.hpp"
#include "solids.hpp"

#include <imbibe/fluid/gradient_correction.hpp>

namespace stability {

/// The weakly compressible water with walls that have no guard.
struct Unguarded : WeaklyCompressible {
    static constexpr const char* name = "weakly compressible, walls without a guard";
    using WeaklyCompressible::set;
    static void set(Sides& sides, const Water& water) {
        WeaklyCompressible::set(sides, water);
        sides.set(sph::KernelRepulsionParameters{.stiffness = 0});
    }
};

/// Water in a tank whose walls are so many layers of particles thick, 16 spacings deep under so much gravity that the
/// pressure at its bottom is that of `value` metres of water on earth; c is ten times the speed of a fall of 1 m.
/// Row 10.
template <class F, int layers, class Real = double>
Outcome thin_wall(const Plan& plan) {
    constexpr double wide = 16, depth = wide * dx;
    const double heavy = g * plan.value / depth, c = 10 * std::sqrt(2 * g * 1.0), unit = std::sqrt(depth / heavy);
    auto scene = fluid_scene<F, Real>(heavy, c);
    const auto water = add_water<F>(scene, pool<F>(wide, wide), c);
    const double inner = (wide + 2 * F::gap) * dx;
    add_tank<F>(scene, sph::Box<2>{{0, 0}, {inner, 1.5 * inner}}, c, sph::Sides::y_high, layers);
    const double end = 4 * unit;
    const Watch<2> watch{.end = end,
                         .guard = {.energy = std::numeric_limits<double>::infinity()},
                         .signs = {{"particles through the wall", 0.5}},
                         .expected_steps = end * c / dx};
    return march(scene, plan, watch, [&](const auto& s) {
        const auto x = s[water][sph::position];
        int out = 0;
        for (Eigen::Index i = 0; i < x.rows(); ++i)
            out += x(i, 1) < Real(-layers * dx) || x(i, 0) < Real(-layers * dx) || x(i, 0) > Real(inner + layers * dx);
        return std::vector{static_cast<double>(out)};
    });
}

/// A drop of 4 x 4 particles that is thrown against an upright wall, at `value` sound speeds, and falls along it by 20
/// spacings. Walls without friction do not hold it: on average it falls as if they were not there.
template <class F, class Real = double>
Outcome drop_along_wall(const Plan& plan) {
    const double c = 30, end = std::sqrt(2 * 20 * dx / g);
    auto scene = fluid_scene<F, Real>(g, c);
    const double off = F::gap * dx;
    const auto water = add_water<F>(scene, sph::fill(sph::Box<2>{{off, 0}, {off + 4 * dx, 4 * dx}}, dx), c);
    typename F::Tank wall{{.density = 1000}};
    wall.sound_speed = c;
    scene.add(wall, sph::fill(sph::Box<2>{{-3 * dx, -40 * dx}, {0, 40 * dx}}, dx), dx);
    scene[water][sph::velocity].col(0).setConstant(Real(-plan.value * c));
    const double top = scene[water][sph::position].col(1).mean();
    const Watch<2> watch{.end = end,
                         .guard = {.energy = std::numeric_limits<double>::infinity()},
                         .signs = {{"lag behind free fall, spacings", 1}},
                         .expected_steps = end * c / dx};
    return march(scene, plan, watch, [&](const auto& s) {
        const double fallen = top - s[water][sph::position].col(1).mean();
        return std::vector{std::abs(fallen - 0.5 * g * sph::sq(s.time())) / dx};
    });
}

/// Water on a floor with two slots, each `value` spacings between its faces. Does any pass, and does the floor bear the
/// weight? Row 17. (Between particles on the two sides of a slot there is one spacing more.)
template <class F, class Real = double>
Outcome slotted_floor(const Plan& plan) {
    constexpr double wide = 16, depth = wide * dx;
    const double c = 10 * std::sqrt(2 * g * depth), unit = std::sqrt(depth / g), off = F::gap * dx;
    auto scene = fluid_scene<F, Real>(g, c);
    const auto water = add_water<F>(scene, pool<F>(wide, wide), c);
    const double inner = (wide + 2 * F::gap) * dx, slot = plan.value * dx;
    typename F::Tank tank{{.density = 1000}};
    tank.sound_speed = c;
    std::vector<sph::Point<2>> walls =
        sph::tank(sph::Box<2>{{0, 0}, {inner, 1.5 * inner}}, dx, 3, sph::Sides::y_high | sph::Sides::y_low);
    // three rows of floor in three pieces
    for (const double y : {-0.5 * dx, -1.5 * dx, -2.5 * dx}) {
        for (double x = inner / 4 - slot / 2 - 0.5 * dx; x > -2.9 * dx; x -= dx) {
            walls.push_back({x, y});
            walls.push_back({inner - x, y});
        }
        const double from = inner / 4 + slot / 2 + 0.5 * dx, to = inner - from;
        const int pieces = static_cast<int>(std::lround((to - from) / dx));
        for (int k = 0; k <= pieces; ++k)
            walls.push_back({from + (to - from) * k / pieces, y});
    }
    scene.add(tank, walls, dx);
    const double end = 6 * unit;
    const Watch<2> watch{
        .end = end,
        .guard = {.energy = std::numeric_limits<double>::infinity()},
        .signs = {{"particles that came through", 0.5}, {"pressure on the floor, its error over rho g h", 0.1}},
        .every = 10, // 50 are, with the longest steps, as long as a wave takes up and down the water
        .expected_steps = end * c / dx};
    double pressed = 0, weight = 0; // since it settled
    return march(scene, plan, watch, [&](const auto& s) {
        const auto x = s[water][sph::position];
        const auto p = s[water][sph::pressure];
        int out = 0;
        for (Eigen::Index i = 0; i < x.rows(); ++i) {
            const double y = static_cast<double>(x(i, 1));
            out += y < -3.2 * dx;
            if (s.time() > 3 * unit && y > 0 && y < off + 1.1 * dx) {
                pressed += static_cast<double>(p(i));
                weight += 1000 * g * (off + depth - y);
            }
        }
        return std::vector{static_cast<double>(out), s.time() > 5 * unit ? std::abs(pressed / weight - 1) : 0};
    });
}

/// The greatest entry of the corrections of gradients.
template <class View>
double greatest_correction(const View& phase) {
    return static_cast<double>(phase[sph::gradient_correction].cwiseAbs().maxCoeff());
}
/// The same of a total-Lagrangian solid, times the root of the share of its stress that a particle carries: its
/// stiffness goes with the square of this.
template <class View>
double greatest_correction_that_acts(const View& phase) {
    double greatest = 0;
    for (int i = 0; i < phase.size(); ++i)
        greatest =
            std::max(greatest, std::sqrt(static_cast<double>(phase[sph::stress_share](i))) *
                                   static_cast<double>(phase[sph::gradient_correction].row(i).cwiseAbs().maxCoeff()));
    return greatest;
}
/// `points`, each moved by up to `most` in every direction, the same in every run.
template <int dim>
std::vector<sph::Point<dim>> roughened(const std::vector<sph::Point<dim>>& points, double most) {
    return sph::jitter<dim>(points, most, 7);
}

/// A sheet, a thread, a single particle and a cube of a total-Lagrangian solid, shaken particle by particle; sheet and
/// thread are rough by `value` spacings. Row 4: in a sheet gradients across it are not known.
template <class S>
Outcome thin_solids_with(const Plan& plan, const sph::ReferenceCorrectionParameters& correction) {
    constexpr double spacing = 1e-2, far = 0.2;
    SolidScene<S, 3, double> scene({.support_radius = S::support * spacing, .threads = 1});
    auto body = body_of<S>(0.3);
    body.set(correction);
    const double c = body.longitudinal_wave_speed(), rough = plan.value * spacing;
    const auto box = [&](double x, double wide, double deep, double high) {
        return sph::fill(sph::Box<3>{{x, 0, 0}, {x + wide * spacing, deep * spacing, high * spacing}}, spacing);
    };
    auto points = roughened<3>(box(0, 8, 8, 1), rough);
    for (const auto& more : {roughened<3>(box(far, 8, 1, 1), rough), box(2 * far, 4, 4, 4), box(3 * far, 1, 1, 1)})
        points.insert(points.end(), more.begin(), more.end());
    const auto parts = scene.add(body, points, spacing);
    shake(scene[parts], 1e-4 * c);
    Growth growth;
    const Watch<3> watch{
        .end = 200 * spacing / c,
        .guard = {.energy = std::numeric_limits<double>::infinity()},
        .signs = {{"kinetic energy over that at the start", 4}, {"greatest correction of a gradient", 15}},
        .expected_steps = 200};
    return march(scene, plan, watch, [&](const auto& s) {
        return std::vector{growth(s[parts]), greatest_correction_that_acts(s[parts])};
    });
}

template <class S>
Outcome thin_solids(const Plan& plan) {
    return thin_solids_with<S>(plan, {});
}

/// Water with corrected gradients in its density diffusion.
struct Corrected {
    using K = sph::WendlandC2;
    struct Water : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::CurrentCorrection<K>,
                              sph::AntuonoDiffusion<K>, sph::VolumePressure<K>, sph::MonaghanViscosity<K>> {};
};
/// Drops: a square of water, a thread that is rough by `value` spacings, a pair and a single particle, shaken. Row 4.
inline Outcome thin_water(const Plan& plan) {
    const double c = 30;
    sph::Solver<2, double, sph::SymplecticEuler, Corrected::Water> scene({.support_radius = 2.6 * dx, .threads = 1});
    auto points = sph::fill(sph::Box<2>{{0, 0}, {6 * dx, 6 * dx}}, dx);
    for (const auto& x : roughened<2>(sph::fill(sph::Box<2>{{20 * dx, 0}, {21 * dx, 30 * dx}}, dx), plan.value * dx))
        points.push_back(x);
    for (const double x : {40.0, 41.0, 60.0})
        points.push_back({x * dx, 0});
    const auto water = scene.add(Corrected::Water{{.density = 1000, .sound_speed = c}}, points, dx);
    shake(scene[water], 1e-3 * c);
    auto view = scene[water];
    for (int i = 0; i < view.size(); ++i) // something to diffuse
        view[sph::density](i) += i % 2 == 0 ? 1 : -1;
    Growth growth;
    const Watch<2> watch{
        .end = 200 * dx / c,
        .guard = {.energy = std::numeric_limits<double>::infinity()},
        .signs = {{"kinetic energy over that at the start", 4}, {"greatest correction of a gradient", 15}},
        .every = 1,
        .expected_steps = 200};
    return march(scene, plan, watch, [&](const auto& s) {
        return std::vector{growth(s[water]), s.steps() > 0 ? greatest_correction(s[water]) : 0};
    });
}

} // namespace stability
