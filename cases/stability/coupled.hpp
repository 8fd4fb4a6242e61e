// Water and solid together: the coupled compositions of the gauntlet and the scenes they are tried in.
#pragma once

#include "fluids.hpp"
#include "solids.hpp"

#include <cmath>

namespace stability {

/// What a composition has where it says nothing else.
struct AsUsual {
    static constexpr double body_spacing = 1; // of the water's
    static constexpr int search_interval = 1; // steps that neighbours serve
};

/// presets::SoundSponge in two dimensions.
struct SoundCoupling : AsUsual {
    static constexpr const char* name = "sound sponge";
    using Fluid = WeaklyCompressible;
    using Preset = sph::presets::SoundSponge;
    using Body = Preset::Sponge;
    using Contact = Preset::Contact;
    static constexpr double body_support = 2, gap = 0;
    static void set(Body&) {}
    static void set(Contact& contact, const Fluid::Water& water) { Preset::set_coefficients(contact, water); }
};

/// The same as SpongeCase offers it: lists of neighbours that serve several steps; and with a body that is finer than
/// the water, as the sponge's is (there 0.5 mm to 0.8).
struct SoundCouplingAsOffered : SoundCoupling {
    static constexpr const char* name = "sound sponge, neighbours for 4 steps";
    static constexpr int search_interval = 4;
};
struct SoundCouplingFiner : SoundCouplingAsOffered {
    static constexpr const char* name = "sound sponge twice as fine as the water, neighbours for 4 steps";
    static constexpr double body_spacing = 0.5;
};

/// The Riemann fluid on a total-Lagrangian solid.
struct RiemannCoupling : AsUsual {
    static constexpr const char* name = "Riemann on St. Venant-Kirchhoff";
    using Fluid = Riemann;
    using K = sph::WendlandC2;
    using Body = Kirchhoff::Body;
    struct Contact
        : sph::Coupling<Fluid::Water, Body, sph::Into<Fluid::Water, sph::RiemannWallNormal<K>>,
                        sph::RiemannWallPressure<K>, sph::Into<Fluid::Water, sph::RiemannWallContinuity<K>>> {};
    static constexpr double body_support = 2, gap = 0;
    static void set(Body&) {}
    static void set(Contact& contact, const Fluid::Water&) {
        contact.set(sph::RiemannWallPressureParameters{.suction = false});
    }
};

/// presets::PaperSponge in two dimensions.
struct PaperCoupling : AsUsual {
    static constexpr const char* name = "paper";
    using Fluid = Paper;
    using K = sph::Spiky;
    using Body = Hypoelastic::Body;
    struct Contact : sph::Coupling<Fluid::Water, Body, sph::VolumeContinuity<K>, sph::SymmetricPressure<K>,
                                   Fluid::Viscosity, sph::KernelRepulsion<K>> {};
    static constexpr double body_support = 1.25, gap = 1.25;
    static void set(Body& body) { Hypoelastic::set(body); }
    static void set(Contact& contact, const Fluid::Water&) {
        contact.set(sph::KernelRepulsionParameters{.stiffness = 1e8});
    }
};

/// The same in space.
struct PaperCouplingInSpace : PaperCoupling {
    using Fluid = PaperInSpace;
    using Preset = sph::presets::PaperSponge;
    using Body = Preset::Sponge;
    using Contact = Preset::Contact;
    static void set(Body& body) { Hypoelastic::set(body); }
    static void set(Contact& contact, const Fluid::Water&) {
        contact.set(sph::KernelRepulsionParameters{.stiffness = 1e8});
    }
};

/// The same coupling with another integrator.
template <class C, class With>
struct CoupledWith : C {
    using Fluid = Integrated<typename C::Fluid, With>;
};

template <class C, class Real, int dim = 2>
using CoupledScene = sph::Solver<dim, Real, typename C::Fluid::Integrator, typename C::Fluid::Water, typename C::Body,
                                 typename C::Fluid::Tank, typename C::Contact, typename C::Fluid::Sides>;

template <class C, class Real, int dim = 2>
CoupledScene<C, Real, dim> coupled_scene(double c) {
    CoupledScene<C, Real, dim> scene({.gravity = downwards<dim>(g),
                                      .support_radius = C::Fluid::support * dx,
                                      .search_interval = C::search_interval,
                                      .threads = 1});
    const auto water = water_of<typename C::Fluid>(c);
    C::Fluid::set(scene.template coupling<typename C::Fluid::Sides>(), water);
    C::set(scene.template coupling<typename C::Contact>(), water);
    return scene;
}
/// Particles of a body that fill a box.
template <class C, int dim>
std::vector<sph::Point<dim>> body_points(const sph::Box<dim>& box) {
    return sph::fill(box, C::body_spacing * dx);
}
/// @param points `C::body_spacing * dx` apart
template <class C, class Scene, class Points>
auto add_body(Scene& scene, const Points& points, double E, double poisson, double density) {
    auto body = elastic<typename C::Body>(E, poisson, density);
    body.support_radius = C::body_support * C::body_spacing * dx;
    C::set(body);
    return scene.add(body, points, C::body_spacing * dx);
}

/// Does a point have particles of a body on all sides of it, within 1.5 of its spacings? The directions to them add up
/// to less than 0.3 of their number: at a plane surface that is so from a tenth of a spacing below the outermost layer
/// on, however the body has bent.
template <class Point, class Positions>
bool is_surrounded(const Point& x, const Positions& body, double spacing) {
    using Real = typename Point::Scalar;
    Eigen::Matrix<Real, 1, Positions::ColsAtCompileTime> sum;
    sum.setZero();
    int near = 0;
    for (Eigen::Index j = 0; j < body.rows(); ++j) {
        const auto off = (body.row(j) - x).eval();
        const Real distance = off.norm();
        if (distance < static_cast<Real>(1.5 * spacing)) {
            sum += off / std::max(distance, static_cast<Real>(1e-9 * spacing));
            ++near;
        }
    }
    return near > 1 && sum.norm() < static_cast<Real>(0.3) * static_cast<Real>(near);
}

/// A block of water falls with `value` m/s on a plate that is held at two ends.
template <class C, class Real = double, int dim = 2>
Outcome water_on_plate(const Plan& plan) {
    const double v = plan.value, c = 30;
    auto scene = coupled_scene<C, Real, dim>(c);
    constexpr double half = (dim == 2 ? 15 : 10) * dx;
    const auto plate = add_body<C>(scene, body_points<C>(box<dim>({-half, -5 * dx}, {half, 0})), 1e6, 0.3, 950);
    scene.hold(plate, [](const auto& x) { return std::abs(x[0]) > half - 3 * dx; });
    auto block = sph::fill(box<dim>({-half / 3, 0}, {half / 3, 2 * half / 3}), dx);
    for (auto& x : block)
        x[1] += (C::gap + 1) * dx;
    const auto water = add_water<typename C::Fluid>(scene, block, c);
    scene[water][sph::velocity].col(1).setConstant(static_cast<Real>(-v));
    const Watch<dim> watch{.end = 15 * dx / v,
                         .guard = {.energy = 0.05},
                         .signs = {{"particles inside the plate", 0.5}},
                         .expected_steps = 15 * c / v};
    return march(scene, plan, watch, [&](const auto& s) {
        const auto w = s[water][sph::position], p = s[plate][sph::position];
        int inside = 0;
        for (Eigen::Index i = 0; i < w.rows(); ++i)
            inside += is_surrounded(w.row(i), p, C::body_spacing * dx);
        return std::vector{static_cast<double>(inside)};
    });
}

/// Water and a block beside it, in free fall: nothing may move against anything else, and no pressure arise. Row 21.
template <class C, class Real = double>
Outcome free_fall(const Plan& plan) {
    auto scene = coupled_scene<C, Real>(30);
    const auto water = add_water<typename C::Fluid>(scene, sph::fill(sph::Box<2>{{0, 0}, {8 * dx, 8 * dx}}, dx), 30);
    const auto block = add_body<C>(scene, body_points<C>(sph::Box<2>{{12 * dx, 0}, {18 * dx, 6 * dx}}), 1e6, 0.3, 950);
    const double end = 0.02;
    const Watch<2> watch{
        .end = end,
        .signs = {{"relative speed over that of the fall", 0.01}, {"pressure over that of still water", 0.05}},
        .expected_steps = end * 50 / dx};
    return march(scene, plan, watch, [&](const auto& s) {
        const auto w = s[water][sph::velocity], b = s[block][sph::velocity];
        const auto first = b.row(0).eval();
        const Real apart =
            std::max((w.rowwise() - first).cwiseAbs().maxCoeff(), (b.rowwise() - first).cwiseAbs().maxCoeff());
        const Real pressed = s.steps() > 0 ? s[water][sph::pressure].cwiseAbs().maxCoeff() : Real(0);
        return std::vector{static_cast<double>(apart) / (g * end), static_cast<double>(pressed) / (1000 * g * 8 * dx)};
    });
}

/// A block that is `value` times as heavy as water is let go on a pool. Row 8: what it has to push is its added mass.
template <class C, class Real = double, int dim = 2>
Outcome block_on_pool(const Plan& plan) {
    constexpr double wide = dim == 2 ? 20 : 14, deep = dim == 2 ? 8 : 6, off = C::gap * dx, inner = wide * dx + 2 * off, surface = deep * dx + off;
    // The film under a sinking block has to stop the block, not the water alone.
    const double c = 10 * std::sqrt(2 * g * deep * dx * std::max(1.0, plan.value)), unit = std::sqrt(deep * dx / g);
    auto scene = coupled_scene<C, Real, dim>(c);
    add_water<typename C::Fluid>(scene, pool<typename C::Fluid, dim>(wide, deep), c);
    add_tank<typename C::Fluid>(scene, box<dim>({0, 0}, {inner, inner}), c);
    auto points = body_points<C>(box<dim>({0, 0}, {8 * dx, 4 * dx}));
    for (auto& x : points)
        x += at<dim>(inner / 2 - 4 * dx, surface + off);
    const double density = 1000 * plan.value;
    const auto block = add_body<C>(scene, points, 2e4, 0.3, density);
    double before = 0, push = 0, change = 0; // momentum, its rate, the change of the rate
    double time = 0;
    int flips = 0, looks = 0;
    // A heavy one is watched until it would lie on the floor if it fell freely: nothing acts between it and the tank.
    const double end = (plan.value > 2 ? std::sqrt(2.0) : 3) * unit;
    const double c_body = scene[block].material().longitudinal_wave_speed();
    const Watch<dim> watch{.end = end,
                         .guard = {},
                         .signs = {{"speed of the block over that of waves", 3},
                                   {"share of steps in which the push changes its course", 0.9}},
                         .every = 1,
                         .expected_steps = end * std::max(c, c_body) / dx};
    return march(scene, plan, watch, [&](const auto& s) {
        const double now = sph::momentum(s[block])[1];
        if (s.time() > time) {
            const double push_now = (now - before) / (s.time() - time), change_now = push_now - push;
            flips += change_now * change < 0;
            ++looks;
            push = push_now;
            change = change_now;
            before = now;
            time = s.time();
        }
        const double mass = density * static_cast<double>(points.size()) * sph::power<dim>(C::body_spacing * dx);
        return std::vector{std::abs(now) / mass / std::sqrt(g * deep * dx),
                           looks > 50 ? static_cast<double>(flips) / looks : 0};
    });
}

} // namespace stability
