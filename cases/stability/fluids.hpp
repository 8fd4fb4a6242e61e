// The fluids of the gauntlet, each with its walls, and the scenes they are tried in.
//
// With the spacing and the walls of the paper's water, in the plane or in space. In both y points upwards; what is a
// square or a strip in the plane is a cube or a square there. Speeds are given in sound speeds.
#pragma once

#include "march.hpp"
#include "signs.hpp"

#include <imbibe/fluid/corrected_gradients.hpp>
#include <imbibe/fluid/riemann.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/methods/weakly_compressible.hpp>
#include <imbibe/presets/sponge.hpp>
#include <imbibe/wall/riemann_wall.hpp>

namespace stability {

inline constexpr double dx = 0.8e-3, g = 9.81; // m, m/s^2

/// Weakly compressible water: presets::SoundWater.
struct WeaklyCompressible {
    static constexpr const char* name = "weakly compressible";
    using Integrator = sph::SymplecticEuler;
    static constexpr double support = 2.6, gap = 0; // H and the distance of water from a wall, in spacings
    using Preset = sph::presets::SoundWater;
    using Water = Preset::Water;
    using Tank = Preset::Vessel;
    using Sides = Preset::Sides;
    static void set(Water& water) { Preset::set_coefficients(water); }
    static void set(Sides& sides, const Water& water) { Preset::set_coefficients(sides, water); }
};

/// The same with a support of 2 spacings.
struct Narrow : WeaklyCompressible {
    static constexpr const char* name = "weakly compressible, H = 2";
    static constexpr double support = 2;
    using WeaklyCompressible::set;
};

/// The same without Monaghan's beta and without the guard within the water: nothing parts what meets fast.
struct Unbraked : WeaklyCompressible {
    static constexpr const char* name = "weakly compressible without beta and guard";
    using WeaklyCompressible::set;
    static void set(Water& water) {
        WeaklyCompressible::set(water);
        water.set(sph::MonaghanViscosityParameters{.alpha = 0.02});
        water.set(sph::KernelRepulsionParameters{.stiffness = 0});
    }
};

/// The water of the dam break in the README: stiffer state, no slack under its floor, walls that pull.
struct DamBreak {
    static constexpr const char* name = "README's dam break";
    using Integrator = sph::SymplecticEuler;
    static constexpr double support = 2.6, gap = 0;
    using K = sph::WendlandC2;
    struct Water : sph::Fluid<sph::Tait<7>, sph::WeaklyCompressible<K>, sph::MonaghanViscosity<K>> {};
    struct Tank : sph::Wall<> {};
    struct Sides : sph::CouplingOf<Water, Tank> {};
    static void set(Water& water) { water.set(sph::MonaghanViscosityParameters{.alpha = 0.02, .beta = 1}); }
    static void set(Sides&, const Water&) {}
};

/// The same as it was before it had a floor: under tension its particles clump, and drops that have come off burst.
struct FloorlessDamBreak : DamBreak {
    static constexpr const char* name = "README's dam break without floor";
    struct Water : sph::Fluid<sph::Tait<7>, sph::WeaklyCompressible<K>, sph::Instead<sph::DensityFloor>,
                              sph::MonaghanViscosity<K>> {};
    struct Sides : sph::CouplingOf<Water, Tank> {};
    static void set(Water& water) { water.set(sph::MonaghanViscosityParameters{.alpha = 0.02, .beta = 1}); }
    static void set(Sides&, const Water&) {}
};

/// The same without Monaghan's beta.
struct UnbrakedDamBreak : DamBreak {
    static constexpr const char* name = "README's dam break without beta";
    using DamBreak::set;
    static void set(Water& water) { water.set(sph::MonaghanViscosityParameters{.alpha = 0.02}); }
};

/// That with a guard on its walls: a repulsion over less than a spacing, as stiff as rho c^2 in the splash.
struct GuardedDamBreak : UnbrakedDamBreak {
    static constexpr const char* name = "README's dam break with a guard in place of beta";
    struct Sides : sph::CouplingOf<Water, Tank, sph::KernelRepulsion<>> {};
    using UnbrakedDamBreak::set;
    static void set(Sides& sides, const Water&) {
        sides.set(sph::KernelRepulsionParameters{.stiffness = 1e5, .range = 0.8});
    }
};

/// Riemann problems between particles and at the wall.
struct Riemann {
    static constexpr const char* name = "Riemann";
    using Integrator = sph::SymplecticEuler;
    static constexpr double support = 3, gap = 0;
    using K = sph::WendlandC2;
    struct Water : sph::Fluid<sph::LinearState, sph::RiemannContinuity<K>, sph::RiemannPressure<K>, sph::DensityFloor> {
    };
    struct Tank : sph::Wall<> {};
    struct Sides : sph::Coupling<Water, Tank, sph::Into<Water, sph::RiemannWallNormal<K>>, sph::RiemannWallPressure<K>,
                                 sph::Into<Water, sph::RiemannWallContinuity<K>>> {};
    static void set(Water&) {}
    static void set(Sides& sides, const Water&) { sides.set(sph::RiemannWallPressureParameters{.suction = false}); }
};

/// Corrected kernel gradients in continuity and pressure, plain ones at the walls; with floor and beta, as in the
/// README's dam break.
struct CorrectedGradients {
    static constexpr const char* name = "corrected gradients";
    using Integrator = sph::SymplecticEuler;
    static constexpr double support = 3, gap = 0;
    using K = sph::WendlandC2;
    struct Water
        : sph::Fluid<sph::LinearState, sph::CurrentCorrection<K>, sph::CorrectedContinuity<K>, sph::DensityDiffusion<K>,
                     sph::DensityFloor, sph::CorrectedPressure<K>, sph::MonaghanViscosity<K>> {};
    struct Tank : sph::Wall<> {};
    struct Sides : sph::Coupling<Water, Tank, sph::Into<Water, sph::CorrectionNeighbours<K>>,
                                 sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                                 sph::Into<Water, sph::VolumeContinuity<K>>> {};
    static void set(Water& water) { water.set(sph::MonaghanViscosityParameters{.alpha = 0.02, .beta = 1}); }
    static void set(Sides&, const Water&) {}
};

/// The paper's water and walls, as in presets::PaperSponge, with the kernel of its viscosity in two dimensions.
struct Paper {
    static constexpr const char* name = "paper";
    using Integrator = sph::StaggeredLeapfrog;
    static constexpr double support = 1.25, gap = 1.25;
    using K = sph::Spiky;
    using Viscosity = sph::LaminarViscosity<sph::ViscosityKernel2D>;
    struct Water : sph::Fluid<sph::Tait<7>, sph::Continuity<K>, sph::SymmetricPressure<K>, Viscosity> {};
    struct Tank : sph::Wall<sph::Tait<7>> {};
    struct Sides : sph::Coupling<Water, Tank, sph::VolumeContinuity<K>, sph::SymmetricPressure<K>, Viscosity,
                                 sph::KernelRepulsion<K>> {};
    static void set(Water& water) { water.viscosity = 3.5e-3; }
    static void set(Sides& sides, const Water&) { sides.set(sph::KernelRepulsionParameters{.stiffness = 1e8}); }
};

/// The same in space.
struct PaperInSpace : Paper {
    using Preset = sph::presets::PaperSponge;
    using Water = Preset::Water;
    using Tank = Preset::Vessel;
    using Sides = Preset::Sides;
    static void set(Water& water) { water.viscosity = 3.5e-3; }
    static void set(Sides& sides, const Water&) { sides.set(sph::KernelRepulsionParameters{.stiffness = 1e8}); }
};

/// The same fluid with another integrator.
template <class F, class With>
struct Integrated : F {
    using Integrator = With;
};

template <class F, class Real, int dim = 2>
using FluidScene =
    sph::Solver<dim, Real, typename F::Integrator, typename F::Water, typename F::Tank, typename F::Sides>;

/// The point at the height y whose other coordinates are x, m.
template <int dim>
sph::Point<dim> at(double x, double y) {
    sph::Point<dim> point = sph::Point<dim>::Constant(x);
    point[1] = y;
    return point;
}
/// A box from `low` to `high`, m; in space as long along z as along x.
template <int dim>
sph::Box<dim> box(const sph::Point<2>& low, const sph::Point<2>& high) {
    return {at<dim>(low[0], low[1]), at<dim>(high[0], high[1])};
}

/// The water of fluid F with a sound speed, m/s.
template <class F>
typename F::Water water_of(double c) {
    typename F::Water water{{.density = 1000, .sound_speed = c}};
    F::set(water);
    return water;
}
/// The gravity of so many m/s^2 along -y.
template <int dim>
std::array<double, static_cast<std::size_t>(dim)> downwards(double gravity) {
    std::array<double, static_cast<std::size_t>(dim)> all{};
    all[1] = -gravity;
    return all;
}
/// A scene of fluid F with a sound speed, m/s, that is empty so far.
template <class F, class Real, int dim = 2>
FluidScene<F, Real, dim> fluid_scene(double gravity, double c,
                                     const std::array<double, static_cast<std::size_t>(dim)>& period = {}) {
    FluidScene<F, Real, dim> scene({.gravity = downwards<dim>(gravity),
                                    .support_radius = F::support * dx,
                                    .periodic_length = period,
                                    .threads = 1});
    F::set(scene.template coupling<typename F::Sides>(), water_of<F>(c));
    return scene;
}
template <class F, class Scene, class Points = std::vector<sph::Point<2>>>
auto add_water(Scene& scene, const Points& points, double c) {
    return scene.add(water_of<F>(c), points, dx);
}
template <class F, class Scene, int dim>
void add_tank(Scene& scene, const sph::Box<dim>& inside, double c, sph::Sides open = sph::Sides::y_high,
              int layers = 3) {
    typename F::Tank tank{{.density = 1000}};
    tank.sound_speed = c;
    scene.add(tank, sph::tank(inside, dx, layers, open), dx);
}
/// Water that fills `wide` by `high` spacings from the lower left corner of a tank.
template <class F, int dim = 2>
std::vector<sph::Point<dim>> pool(double wide, double high) {
    const double off = F::gap * dx;
    return sph::fill(box<dim>({off, off}, {off + wide * dx, off + high * dx}), dx);
}

/// The shortest waves: a periodic square of water, shaken particle by particle.
template <class F, class Real = double, int dim = 2>
Outcome shaken_water(const Plan& plan) {
    constexpr double side = (dim == 2 ? 16 : 10) * dx;
    const double c = 30;
    std::array<double, static_cast<std::size_t>(dim)> period;
    period.fill(side);
    auto scene = fluid_scene<F, Real, dim>(0, c, period);
    const auto water = add_water<F>(scene, sph::fill(box<dim>({0, 0}, {side, side}), dx), c);
    shake(scene[water], 1e-3 * c);
    Growth growth;
    const Watch<dim> watch{.end = 400 * dx / c,
                           .guard = {.energy = std::numeric_limits<double>::infinity()},
                           .signs = {{"kinetic energy over that at the start", 4}},
                           .expected_steps = 400};
    return march(scene, plan, watch, [&](const auto& s) { return std::vector{growth(s[water])}; });
}

/// Mean kinetic energies in parts of a run, each as a share of what was set free.
struct Rest {
    double fifth_tenth = 0, last_tenth = 0;
};

/// Water that is let go in a tank without pressure and comes to rest, for `value` times sqrt(depth/g) (0: 6 of them,
/// some 3400 steps; in space 40, because a cubic lattice under pressure takes 10 to fall into a denser order). Rows 5
/// and 20. @param rest where it is written how much moves late in the run
template <class F, class Real = double, int dim = 2>
Outcome settling_water(const Plan& plan, Rest& rest) {
    constexpr double wide = dim == 2 ? 16 : 8, depth = wide * dx;
    const double c = 10 * std::sqrt(2 * g * depth), weight = sph::power<dim>(depth) * 1000 * g,
                 unit = std::sqrt(depth / g);
    auto scene = fluid_scene<F, Real, dim>(g, c);
    const auto water = add_water<F>(scene, pool<F, dim>(wide, wide), c);
    const double inner = (wide + 2 * F::gap) * dx;
    add_tank<F>(scene, box<dim>({0, 0}, {inner, 1.5 * inner}), c);
    if (dim == 3) // else rounding alone decides when the lattice gives way, and in double that is at the end of the run
        shake(scene[water], 1e-6 * c);
    // What is set free is weight depth/600 where the column bears itself, and the fall to the walls where there is a
    // gap.
    const double fall = F::gap * dx;
    const double released = weight * (depth / 600 + fall);
    const double end = (plan.value > 0 ? plan.value : dim == 2 ? 6 : 40) * unit;
    const Watch<dim> watch{.end = end,
                           .guard = {.energy = std::numeric_limits<double>::infinity()},
                           .signs = {{"alternating pressure over that at the bottom", 0.2},
                                     {"kinetic energy over what is set free", 1},
                                     {"way into the wall, spacings", 1},
                                     {"mean kinetic energy, last tenth over fifth", 2}},
                           .every = 50,
                           .expected_steps = end * c / dx};
    double fifth = 0, last = 0, fifths = 0, lasts = 0; // sums of the kinetic energy over tenths of the run, and counts
    return march(scene, plan, watch, [&](const auto& s) {
        const bool settled = s.time() > 3 * unit;
        const double kinetic = sph::kinetic_energy(s[water]);
        const bool in_fifth = s.time() > 0.4 * end && s.time() <= 0.5 * end, in_last = s.time() > 0.9 * end;
        fifth += in_fifth ? kinetic : 0;
        last += in_last ? kinetic : 0;
        fifths += in_fifth;
        lasts += in_last;
        if (s.time() >= end)
            rest = {fifth / fifths / released, last / lasts / released};
        return std::vector{settled ? alternating(s[water], sph::pressure) / (1000 * g * depth) : 0,
                           settled ? kinetic / released : 0, way_into_wall(s[water], inner),
                           s.time() >= end ? last / fifth : 0};
    });
}

/// The same, where only its indicators are asked for.
template <class F, class Real = double, int dim = 2>
Outcome still_water(const Plan& plan) {
    Rest rest;
    return settling_water<F, Real, dim>(plan, rest);
}

/// A block of water that is thrown on a floor, at `value` sound speeds. Row 7.
template <class F, class Real = double, int dim = 2>
Outcome impact(const Plan& plan) {
    const double c = 30, v = plan.value * c;
    auto scene = fluid_scene<F, Real, dim>(0, c);
    constexpr double half = (dim == 2 ? 6 : 5) * dx;
    auto block = sph::fill(box<dim>({-half, 0}, {half, 2 * half}), dx);
    for (auto& x : block)
        x[1] += (F::gap + 1) * dx;
    const auto water = add_water<F>(scene, block, c);
    constexpr auto open = sph::Sides::x | sph::Sides::y_high;
    constexpr double reach = (dim == 2 ? 30 : 18) * dx;
    add_tank<F>(scene, box<dim>({-reach, 0}, {reach, 10 * dx}), c, dim == 2 ? open : open | sph::Sides::z);
    scene[water][sph::velocity].col(1).setConstant(static_cast<Real>(-v));
    const Watch<dim> watch{.end = 6 * dx / v,
                           .guard = {.energy = 0.05},
                           .signs = {{"spacings over the least distance of a pair", 5},
                                     {"way into the wall, spacings", 1},
                                     {"greatest rise of a density", 0.5}}, // the guard's bound
                           .expected_steps = 6 * c / v};
    return march(scene, plan, watch, [&](const auto& s) {
        const double rise = static_cast<double>(s[water][sph::density].maxCoeff()) / 1000 - 1;
        return std::vector{1 / closest_pair(s[water]), way_into_wall(s[water], reach), std::max(rise, 0.0)};
    });
}

/// A square or cube of water that spins about z: tension in its middle. Row 1: do particles clump? Row 6: does a void
/// open? (In space the water closes in along the axis, to half its height: the middle is a disc in the plane z = 0.)
template <class F, class Real = double, bool voids = false, int dim = 2>
Outcome spinning_square(const Plan& plan) {
    constexpr double side = 20 * dx;
    const double c = 30, omega = 0.1 * c / side;
    auto scene = fluid_scene<F, Real, dim>(0, c);
    const auto water = add_water<F>(scene, sph::fill(box<dim>({-side / 2, -side / 2}, {side / 2, side / 2}), dx), c);
    auto view = scene[water];
    for (int i = 0; i < view.size(); ++i) {
        const Real x = view[sph::position](i, 0), y = view[sph::position](i, 1);
        view[sph::velocity](i, 0) = static_cast<Real>(omega) * y;
        view[sph::velocity](i, 1) = -static_cast<Real>(omega) * x;
    }
    const Watch<dim> watch{
        .end = 1.5 / omega,
        .guard = {},
        .signs = {{voids ? "void in the middle (1 - concentration)" : "spacings over the least distance of a pair",
                   voids ? 0.25 : 2}},
        .every = 20,
        .expected_steps = 1.5 / omega * c / dx};
    return march(scene, plan, watch, [&](const auto& s) {
        const auto inside = [](const auto& x) {
            const bool near_plane = dim == 2 || std::abs(x[dim - 1]) < static_cast<Real>(side / 8);
            return near_plane && x.template head<2>().squaredNorm() < static_cast<Real>(sph::sq(side / 4));
        };
        return std::vector{voids ? 1 - least_concentration(s[water], inside) : 1 / closest_pair(s[water])};
    });
}

/// Small drops that fly freely, 2 to 5 particles each way, stirred by `value` sound speeds: what a splash leaves
/// behind. Row 19.
template <class F, class Real = double, int dim = 2>
Outcome drops_in_flight(const Plan& plan) {
    const double c = 30;
    auto scene = fluid_scene<F, Real, dim>(0, c);
    std::vector<sph::Point<dim>> points;
    for (int across = 2; across <= 5; ++across)
        for (auto x : sph::fill(box<dim>({0, 0}, {across * dx, across * dx}), dx)) {
            x[0] += 20 * across * dx;
            points.push_back(x);
        }
    const auto water = add_water<F>(scene, points, c);
    shake(scene[water], plan.value * c);
    Growth growth;
    const Watch<dim> watch{.end = 2000 * dx / c,
                           .guard = {.energy = std::numeric_limits<double>::infinity()},
                           .signs = {{"kinetic energy over that at the start", 4}},
                           .expected_steps = 2000};
    return march(scene, plan, watch, [&](const auto& s) { return std::vector{growth(s[water])}; });
}

/// A drop falls into a pool and throws single particles up. Row 19.
template <class F, class Real = double, int dim = 2>
Outcome splash(const Plan& plan) {
    constexpr double wide = dim == 2 ? 24 : 14, deep = dim == 2 ? 8 : 6, height = 12 * dx;
    const double v = 1, c = 10 * v, inner = (wide + 2 * F::gap) * dx, surface = (deep + F::gap) * dx;
    auto scene = fluid_scene<F, Real, dim>(g, c);
    auto points = pool<F, dim>(wide, deep);
    for (const auto& x : sph::fill(box<dim>({0, 0}, {6 * dx, 6 * dx}), dx))
        points.push_back(x + at<dim>(inner / 2 - 2.7 * dx, surface + height));
    const auto water = add_water<F>(scene, points, c);
    add_tank<F>(scene, box<dim>({0, 0}, {inner, (dim == 2 ? 3 : 4.5) * inner}), c);
    auto view = scene[water];
    for (int i = 0; i < view.size(); ++i)
        if (view[sph::position](i, 1) > static_cast<Real>(surface + height / 2))
            view[sph::velocity](i, 1) = static_cast<Real>(-v);
    const Watch<dim> watch{.end = 6 * height / v,
                           .guard = {.energy = 0.05},
                           .signs = {{"greatest speed over that of the fall", 3}, {"way into the wall, spacings", 1}},
                           .expected_steps = 6 * height / v * c / dx};
    return march(scene, plan, watch, [&](const auto& s) {
        return std::vector{std::sqrt(static_cast<double>(s[water][sph::velocity].rowwise().squaredNorm().maxCoeff())) /
                               v,
                           way_into_wall(s[water], inner)};
    });
}

} // namespace stability
