// Five couplings of water and a total-Lagrangian solid, interchangeable: what each asks of the solid, its terms between
// the two, and its coefficients for a load. What the water does at walls is the same for all.
#pragma once

#include "../support/elastic.hpp"

#include <imbibe/imbibe.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace couplings {

namespace sph = imbibe;
using K = sph::WendlandC2;
using sph::Coupling;
using sph::Into;

/// What a coupling has to bear.
struct Load {
    double pressure; ///< of water at rest on the solid, Pa
    double speed;    ///< of an impact, m/s
};

/// What a load meets: the support radius and the spacings of water and solid, m.
struct Layers {
    double support, water, solid;
    int dimension;
};

/// The pressure of the water, continued to the solid: Adami, Hu and Adams (2012).
struct Extrapolated {
    static constexpr const char* name = "extrapolated pressure";
    using InSolid = sph::TypeList<>;
    template <class Water, class Solid>
    struct Contact : Coupling<Water, Solid, Into<Solid, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                              Into<Water, sph::VolumeContinuity<K>>> {};
    static double first_gap(const Load&, const Layers&) { return 0; } // the water may touch the solid
    static void set(auto& contact, const Load&, const Layers&) {
        contact.set(sph::PressureExtrapolationParameters{.suction = false});
    }
};

/// One-sided Riemann problems: Zhang, Hu and Adams (2017).
struct Riemann {
    static constexpr const char* name = "one-sided Riemann";
    using InSolid = sph::TypeList<>;
    template <class Water, class Solid>
    struct Contact : Coupling<Water, Solid, Into<Water, sph::RiemannWallNormal<K>>, sph::RiemannWallPressure<K>,
                              Into<Water, sph::RiemannWallContinuity<K>>> {};
    static double first_gap(const Load&, const Layers&) { return 0; }
    static void set(auto& contact, const Load&, const Layers&) {
        contact.set(sph::RiemannWallPressureParameters{.suction = false});
    }
};

/// Pressure along the normals of the solid: after Antoci, Gallati and Sibilla (2007).
struct AlongNormals {
    static constexpr const char* name = "along surface normals";
    using InSolid = sph::TypeList<sph::ReferenceSurfaceNormal<K>>;
    template <class Water, class Solid>
    struct Contact : Coupling<Water, Solid, sph::SurfaceNormalPressure<K>, Into<Water, sph::VolumeContinuity<K>>> {};
    static double first_gap(const Load&, const Layers&) { return 0; }
    static void set(auto&, const Load&, const Layers&) {}
};

/// A spring between close pairs that approach: after the idea of Amini, Emdad and Farid (2011).
struct ModifiedRepulsion {
    static constexpr const char* name = "modified repulsion";
    using InSolid = sph::TypeList<>;
    template <class Water, class Solid>
    struct Contact : Coupling<Water, Solid, sph::ModifiedRepulsion> {};
    static double first_gap(const Load&, const Layers&) { return 0; }
    static void set(auto& contact, const Load& load, const Layers&) {
        contact.set(sph::ModifiedRepulsionParameters{.speed = 18 * std::sqrt(load.pressure / 1000) + load.speed});
    }
};

/// What K_f makes of layers of water and solid whose first ones are d apart, as a pressure over K_f:
///     S(d) = - Dx_w Dx_s sum_i sum_j w'(d + i Dx_w + j Dx_s),   w(s) = int W(sqrt(s^2 + t^2)) dt
/// over the line (2D) or plane (3D) at distance s: all layers i of the water push on all layers j of the solid. With
/// layers much thinner than H it becomes int_d^H w(s) ds, the share of the kernel beyond d.
inline double pressure_over_stiffness(double d, const Layers& layers) {
    const double H = layers.support;
    const double normalisation =
        layers.dimension == 2 ? sph::Spiky::normalisation<2>() / (H * H) : sph::Spiky::normalisation<3>() / (H * H * H);
    const auto slope = [&](double s) { // -w'(s), by midpoints, with t up to the rim
        constexpr int steps = 200;
        const double half = std::sqrt(std::max(H * H - s * s, 0.0));
        double total = 0;
        for (int k = 0; k < steps; ++k) {
            const double t = half * (k + 0.5) / steps, r = std::sqrt(s * s + t * t);
            const double around = layers.dimension == 2 ? 2 : 2 * std::numbers::pi * t;
            total -= sph::Spiky::derivative(r / H) / H * (s / r) * around * half / steps;
        }
        return normalisation * total;
    };
    double total = 0;
    for (double a = d; a < H; a += layers.water)
        for (double s = a; s < H; s += layers.solid)
            total += layers.water * layers.solid * slope(s);
    return total;
}

/// How far K_f keeps the first layers of water and solid apart under a pressure p, m: S(d) = p/K_f.
inline double distance_of_repulsion(double p_over_stiffness, const Layers& layers) {
    double near = 0, far = layers.support;
    for (int k = 0; k < 30; ++k) {
        const double d = 0.5 * (near + far);
        (pressure_over_stiffness(d, layers) > p_over_stiffness ? near : far) = d;
    }
    return near;
}

/// The paper's K_f (24), alone: a total-Lagrangian solid has no pressure that Eq. (23) could exchange. As stiff as in
/// the paper, where it is 1e8 Pa and the water, 57 mm high, weighs 560 Pa.
struct StiffRepulsion {
    static constexpr const char* name = "K_f = 1e5 p";
    using InSolid = sph::TypeList<>;
    template <class Water, class Solid>
    struct Contact : Coupling<Water, Solid, sph::KernelRepulsion<sph::Spiky>> {};
    static double first_gap(const Load&, const Layers& l) {
        return std::max(distance_of_repulsion(1e-5, l) - 0.5 * (l.water + l.solid), 0.0);
    }
    static void set(auto& contact, const Load& load, const Layers&) {
        contact.set(sph::KernelRepulsionParameters{.stiffness = 1e5 * load.pressure});
    }
};

/// K_f scaled so that under its load the first layers are as far apart as layers of one body would be,
/// d = (Dx_w + Dx_s)/2, whatever the support radius: K_f = p/S(d).
struct ScaledRepulsion : StiffRepulsion {
    static constexpr const char* name = "K_f = p/S(d)";
    static double first_gap(const Load&, const Layers&) { return 0; }
    static void set(auto& contact, const Load& load, const Layers& l) {
        const double share = pressure_over_stiffness(0.5 * (l.water + l.solid), l);
        contact.set(sph::KernelRepulsionParameters{.stiffness = load.pressure / share});
    }
};

/// A total-Lagrangian solid with what a coupling needs beside it.
template <class InSolid>
struct SolidFor;
template <class... Extra>
struct SolidFor<sph::TypeList<Extra...>> {
    using type = sph::Solid<sph::TotalLagrangianSolid<sph::StVenantKirchhoff, K>, sph::TotalLagrangianViscosity<K>,
                            sph::Clamped, sph::TimeAveragedMotion, Extra...>;
};

struct Water : sph::Fluid<sph::LinearState, sph::WeaklyCompressible<K>, sph::MonaghanViscosity<K>> {};
template <class Kit>
struct Elastic : SolidFor<typename Kit::InSolid>::type {};
struct Walls : sph::Wall<> {};
struct Sides : Coupling<Water, Walls, Into<Walls, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                        Into<Water, sph::VolumeContinuity<K>>> {};

/// Water, a solid of one kind, walls.
template <int dim, class Real, class Kit>
using Scene = sph::Solver<dim, Real, sph::Subcycled<Elastic<Kit>>, Water, Elastic<Kit>, Walls, Sides,
                          typename Kit::template Contact<Water, Elastic<Kit>>>;

/// Young's modulus in Pa, Poisson's ratio, density in kg/m^3, support radius in m.
template <class Kit>
Elastic<Kit> elastic(double young, double poisson, double density, double support) {
    auto solid = sph::bench::elastic<Elastic<Kit>>(young, poisson, density);
    solid.support_radius = support;
    return solid;
}
inline Water water(double sound_speed) {
    Water w{{.density = 1000, .sound_speed = sound_speed}};
    w.set(sph::MonaghanViscosityParameters{.alpha = 0.02});
    return w;
}
template <class Kit>
void couple(auto& scene, const Load& load, const Layers& layers) {
    Kit::set(scene.template coupling<typename Kit::template Contact<Water, Elastic<Kit>>>(), load, layers);
    scene.template coupling<Sides>().set(sph::PressureExtrapolationParameters{.suction = false});
}

/// The least distance between particles of two phases, m; `reach` where none are nearer.
template <int dim, class A, class B>
double least_distance(const A& a, const B& b, double reach) {
    using Real = typename std::remove_cvref_t<decltype(a[sph::position])>::Scalar;
    if (a.size() == 0 || b.size() == 0)
        return reach;
    sph::search::NeighbourSearch<dim, Real> search(reach, {}, 1);
    const int first = search.add(a[sph::position]), second = search.add(b[sph::position]);
    search.set_support(first, first, 0);
    search.set_support(second, second, 0);
    search.update();
    double least = reach;
    for (int i = 0; i < a.size(); ++i)
        search.for_each(first, i, second,
                        [&](int, const auto&, auto distance) { least = std::min(least, double(distance)); });
    return least;
}

} // namespace couplings
