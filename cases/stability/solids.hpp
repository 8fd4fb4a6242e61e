// The solids of the gauntlet and the scenes they are tried in.
#pragma once

#include "../support/elastic.hpp"
#include "../support/pieces.hpp"
#include "march.hpp"
#include "signs.hpp"

#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/presets/sponge.hpp>
#include <imbibe/solid/neo_hookean.hpp>
#include <imbibe/solid/volumetric_deviatoric.hpp>

#include <numbers>

namespace stability {

inline constexpr double rho = 1000, young = 1e6; // kg/m^3, Pa

/// Total-Lagrangian, as in presets::SoundSponge, with the law of choice.
template <class Law>
struct TotalLagrangian {
    using K = sph::WendlandC2;
    static constexpr double support = 2.01; // spacings
    struct Body
        : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, Law, sph::TotalLagrangianForce<K>,
                     sph::HourglassControl<K>, sph::TotalLagrangianViscosity<K>, sph::Clamped> {};
    static void set(Body&) {}
};
struct Hookean : TotalLagrangian<sph::CompressibleNeoHookean> { // that of the preset
    static constexpr const char* name = "neo-Hookean";
};
struct Kirchhoff : TotalLagrangian<sph::StVenantKirchhoff> {
    static constexpr const char* name = "St. Venant-Kirchhoff";
};
struct Averaged : TotalLagrangian<sph::VolumetricDeviatoric<>> {
    static constexpr const char* name = "volumetric-deviatoric";
    static void set(Body& body) { body.set(sph::HourglassControlParameters{.alpha = 0.3}); } // as its header asks
};
/// The solid of the paper: presets::PaperSponge.
struct Hypoelastic {
    static constexpr const char* name = "paper's hypoelastic";
    static constexpr double support = 2;
    using Body = sph::presets::PaperSponge::Sponge;
    static void set(Body& body) { body.set(sph::MonaghanViscosityParameters{.alpha = 1}); }
};

template <class S, int dim, class Real>
using SolidScene = sph::Solver<dim, Real, sph::SymplecticEuler, typename S::Body>;

using sph::bench::elastic;
template <class S>
typename S::Body body_of(double poisson) {
    auto body = elastic<typename S::Body>(young, poisson, rho);
    S::set(body);
    return body;
}

/// The shortest waves of a free block, shaken particle by particle. Poisson's ratio is `value`.
template <class S, class Real = double>
Outcome shaken_solid(const Plan& plan) {
    constexpr double spacing = 1e-2;
    SolidScene<S, 2, Real> scene({.support_radius = S::support * spacing, .threads = 1});
    const auto body = body_of<S>(plan.value);
    const double c = body.longitudinal_wave_speed();
    const auto block = scene.add(body, sph::fill(sph::Box<2>{{0, 0}, {0.14, 0.14}}, spacing), spacing);
    shake(scene[block], 1e-3 * c);
    Growth growth;
    const Watch<2> watch{.end = 400 * spacing / c,
                         .guard = {.energy = std::numeric_limits<double>::infinity()},
                         .signs = {{"kinetic energy over that at the start", 4}},
                         .expected_steps = 400};
    return march(scene, plan, watch, [&](const auto& s) { return std::vector{growth(s[block])}; });
}

/// A free bar that is pulled: its ends part with `value` times the speed of sound in a bar, so that it stretches by
/// about that. Row 1.
template <class S, class Real = double>
Outcome stretched_bar(const Plan& plan) {
    constexpr double spacing = 1e-2, L = 0.3;
    SolidScene<S, 2, Real> scene({.support_radius = S::support * spacing, .threads = 1});
    const auto body = body_of<S>(0.3);
    const double c = std::sqrt(young / rho);
    const auto points = sph::fill(sph::Box<2>{{-L / 2, 0}, {L / 2, 0.06}}, spacing);
    const auto bar = scene.add(body, points, spacing);
    auto view = scene[bar];
    for (int i = 0; i < view.size(); ++i) // sin: the first mode of a free bar
        view[sph::velocity](i, 0) = static_cast<Real>(
            plan.value * c * std::sin(std::numbers::pi / L * static_cast<double>(view[sph::position](i, 0))));
    const Roughness rough(points, spacing);
    const double period = 2 * L / c;
    const Watch<2> watch{
        .end = 1.5 * period,
        .guard = {.energy = 0.05},
        .signs = {{"roughness of the displacement, spacings", 0.25}, {"spacings over the least distance of a pair", 2}},
        .expected_steps = 1.5 * period * body.longitudinal_wave_speed() / spacing};
    return march(scene, plan, watch, [&](const auto& s) {
        return std::vector{rough(s[bar]), 1 / closest_pair(s[bar])};
    });
}

/// A cantilever, 20 by 5 particles, that starts with a swing; Poisson's ratio is `value`. Rows 3 and 9.
template <class S, class Real = double>
Outcome bent_beam(const Plan& plan) {
    constexpr double spacing = 1e-2, L = 0.2;
    SolidScene<S, 2, Real> scene({.support_radius = S::support * spacing, .threads = 1});
    const auto body = body_of<S>(plan.value);
    const auto points = sph::fill(sph::Box<2>{{-3 * spacing, 0}, {L, 0.05}}, spacing);
    const auto beam = scene.add(body, points, spacing);
    scene.hold(beam, [](const auto& x) { return x[0] < 0; });
    auto view = scene[beam];
    for (int i = 0; i < view.size(); ++i)
        if (view[sph::mobility](i) > 0)
            view[sph::velocity](i, 1) =
                static_cast<Real>(0.03 * std::sqrt(young / rho) * sph::sq(view[sph::position](i, 0) / L));
    const Roughness rough(points, spacing);
    AlternatingMeanStress alternating(points, spacing, [](const auto& x) { return x[0] > 0; });
    const double period = 0.1; // s, nearly: that of a thin beam is 0.078
    const Watch<2> watch{
        .end = period,
        .guard = {.energy = 0.05},
        .signs = {{"roughness of the displacement, spacings", 0.1}, {"share of the mean stress that alternates", 0.5}},
        .expected_steps = period * body.longitudinal_wave_speed() / spacing};
    return march(scene, plan, watch, [&](const auto& s) {
        const double share = s.steps() > 0 ? alternating(s[beam]) : 0;
        return std::vector{rough(s[beam]), s.time() >= period ? share : 0};
    });
}

/// Sets a phase spinning about the origin, rad/s.
template <class View>
void spin(const View& view, double omega) {
    using Real = std::remove_cvref_t<decltype(view[sph::velocity](0, 0))>;
    for (int i = 0; i < view.size(); ++i) {
        const Real x = view[sph::position](i, 0), y = view[sph::position](i, 1);
        view[sph::velocity].row(i) << -static_cast<Real>(omega) * y, static_cast<Real>(omega) * x;
    }
}
/// About the origin, kg m^2/s per metre of depth.
template <class View>
double angular_momentum(const View& view) {
    double sum = 0;
    for (int i = 0; i < view.size(); ++i)
        sum += view[sph::mass](i) * (view[sph::position](i, 0) * view[sph::velocity](i, 1) -
                                     view[sph::position](i, 1) * view[sph::velocity](i, 0));
    return sum;
}

/// A plate that spins for three turns at a tenth of the shear wave speed. Row 14.
template <class S, class Real = double>
Outcome spinning_plate(const Plan& plan) {
    constexpr double spacing = 1e-2, side = 0.12;
    SolidScene<S, 2, Real> scene({.support_radius = S::support * spacing, .threads = 1});
    const auto body = body_of<S>(0.3);
    const double omega = 0.1 * std::sqrt(body.shear_modulus / rho) / (side / 2);
    const auto plate =
        scene.add(body, sph::fill(sph::Box<2>{{-side / 2, -side / 2}, {side / 2, side / 2}}, spacing), spacing);
    const auto view = scene[plate];
    spin(view, omega);
    const double start = angular_momentum(view), widest = side / 2 * std::numbers::sqrt2;
    const double end = 3 * 2 * std::numbers::pi / omega;
    const Watch<2> watch{.end = end,
                         .guard = {.energy = 0.05},
                         .signs = {{"change of the angular momentum", 0.01}, {"growth of its radius", 0.05}},
                         .every = 50,
                         .expected_steps = end * body.longitudinal_wave_speed() / spacing};
    return march(scene, plan, watch, [&](const auto& s) {
        return std::vector{std::abs(angular_momentum(view) / start - 1),
                           static_cast<double>(s[plate][sph::position].rowwise().norm().maxCoeff()) / widest - 1};
    });
}

/// Two rings of rubber that collide with +- `value` bulk sound speeds. Only for solids that see each other: a
/// total-Lagrangian one has no neighbours but those it started with. Row 1.
template <class S, class Real = double>
Outcome colliding_rings(const Plan& plan) {
    constexpr double spacing = 2e-3, inner = 0.03, outer = 0.04;
    SolidScene<S, 2, Real> scene({.support_radius = S::support * spacing, .threads = 1});
    const auto body = body_of<S>(0.3975);
    std::vector<sph::Point<2>> points;
    for (const auto& x : sph::fill(sph::Box<2>{{-outer, -outer}, {outer, outer}}, spacing))
        if (x.norm() > inner && x.norm() < outer)
            for (const double side : {-1.0, 1.0})
                points.push_back(x + side * sph::Point<2>(outer + 2 * spacing, 0));
    const auto rings = scene.add(body, points, spacing);
    auto view = scene[rings];
    const double v = plan.value * body.sound_speed;
    for (int i = 0; i < view.size(); ++i)
        view[sph::velocity](i, 0) = static_cast<Real>(view[sph::position](i, 0) < 0 ? v : -v);
    const Watch<2> watch{.end = 0.04 / v,
                         .guard = {.energy = 0.05},
                         .signs = {{"spacings over the least distance of a pair", 2}, {"pieces of two rings", 2}},
                         .every = 20,
                         .expected_steps = 0.04 / v * body.longitudinal_wave_speed() / spacing};
    return march(scene, plan, watch, [&](const auto& s) {
        const auto found = sph::bench::pieces(s[rings], 1.5 * spacing);
        return std::vector{1 / closest_pair(s[rings]), static_cast<double>(found.sizes.size())};
    });
}

/// A column of 1 x 1 x 6 m in three dimensions, on its way to a twist of a revolution; Poisson's ratio is `value`.
/// Row 9.
template <class S, class Real = double>
Outcome twisted_column(const Plan& plan) {
    constexpr double spacing = 0.25;
    SolidScene<S, 3, Real> scene({.support_radius = S::support * spacing, .threads = 1});
    auto body = elastic<typename S::Body>(1.7e7, plan.value, 1100);
    S::set(body);
    const auto points = sph::fill(sph::Box<3>{{-0.5, -0.5, -2 * spacing}, {0.5, 0.5, 6}}, spacing);
    const auto column = scene.add(body, points, spacing);
    scene.hold(column, [](const auto& x) { return x[2] < 0; });
    auto view = scene[column];
    for (int i = 0; i < view.size(); ++i) {
        const auto x = view[sph::position].row(i).template cast<double>();
        const double omega = static_cast<double>(view[sph::mobility](i)) * 105 * std::sin(std::numbers::pi * x[2] / 12);
        view[sph::velocity].row(i) << static_cast<Real>(-omega * x[1]), static_cast<Real>(omega * x[0]), 0;
    }
    const Roughness rough(points, spacing);
    AlternatingMeanStress alternating(points, spacing, [](const auto& x) { return x[2] > 0; });
    const double end = 0.09;
    const Watch<3> watch{
        .end = end,
        .guard = {.energy = 0.05},
        .signs = {{"roughness of the displacement, spacings", 0.3}, {"share of the mean stress that alternates", 0.5}},
        .every = 50,
        .expected_steps = end * body.longitudinal_wave_speed() / spacing};
    return march(scene, plan, watch, [&](const auto& s) {
        const double share = s.steps() > 0 ? alternating(s[column]) : 0;
        return std::vector{rough(s[column]), s.time() >= end ? share : 0};
    });
}

} // namespace stability
