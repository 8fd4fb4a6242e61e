// A soft skeleton full of water is pressed from outside: the water in its pores bears the load at first, and drains
// through the surface (Biot 1941). A layer, and a ball, in whose middle the pressure rises before it falls.
//
// Reference: the layer, Terzaghi (1943), series: the degree of consolidation U = 1 - mean p/p at the start, and p in
// the middle over that at the start, at T = c t/a^2. The ball, Cryer (1963), for Poisson's ratio 0: p in the middle
// over the load. Water that is not compressed: c = k (K + 4 G/3)/eta. Geometry: the layer is plane, periodic to the
// sides, 2 a thick and loaded on both faces; the ball has the radius a. The particles are counted over a = 1 m, the
// skeleton's modulus K + 4 G/3 is 1e5 Pa, its porosity 0.5, the load 100 Pa. The water is 20 times as stiff, which c =
// k/eta/(1/(K + 4 G/3) + n/K_water) counts. Scheme: the mixture: InPores, SeepingFluid without its density floor
// (nothing parts), PorousSkeleton; Wendland C2 of 3 spacings (2.6 in the ball). It starts with all of the load in the
// water. Measure: as the reference has it.
#pragma once

#include "case.hpp"

#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/fitted.hpp>
#include <imbibe/geometry/sphere.hpp>
#include <imbibe/methods/seeping_fluid.hpp>
#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/mixture/fill_pores.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace validation::biot {

namespace sph = imbibe;
using K = sph::WendlandC2;

struct LoadParameters {
    double pressure = 0; ///< Pa, on all of the surface
};
/// A pressure around the skeleton: as if all of it were pulled together by as much.
struct Load : sph::NotStiff {
    using Parameters = LoadParameters;
    struct Pull {
        using reads = sph::Fields<sph::mass>;
        using adds = sph::Fields<sph::pore_stress>;
        Parameters parameters{};

        constexpr auto operator()(const auto& a) const { return 0 * a[sph::mass] - parameters.pressure; }
    };
    using parts = sph::Parts<Pull>;
};

struct Water : sph::Fluid<sph::InPores<>, sph::SeepingFluid<K>, sph::Instead<sph::PoreDensityFloor>> {};
struct Soil : sph::Solid<sph::TotalLagrangianSolid<sph::PorousSkeleton<>, K>, sph::TotalLagrangianViscosity<K>, Load> {
};
struct InSoil : sph::CouplingOf<Water, Soil> {};

/// A body of wet soil of the half-width 1 m.
template <int dim>
struct Body {
    static constexpr double n = 0.5, modulus = 1e5, bulk = 2e6, c = 0.02, load = 100, rho = 1000;
    using Scene = sph::Solver<dim, double, sph::SymplecticEuler, Water, Soil, InSoil>;
    double dx;
    Scene scene;
    sph::PhaseHandle<Water> water;

    explicit Body(int across)
        : dx(1.0 / across),
          scene({.support_radius = (dim == 2 ? 3 : 2.6) * dx, .cfl = 0.8, .periodic_length = sides(dx)}) {
        // p is 0 at the outermost particles of the water: they are on the surface.
        const auto places = [&](double radius) {
            if constexpr (dim == 2)
                return sph::fill(sph::Box<2>{{0, -radius}, {8 * dx, radius}}, dx);
            else
                return sph::fitted(sph::Sphere<3>{{0, 0, 0}, radius}, dx);
        };
        Water liquid{{.density = rho, .sound_speed = std::sqrt(bulk / rho), .viscosity = 1}};
        liquid.set(sph::PoreDensityDiffusionParameters{.delta = 0.002, .delta_in_pores = 0.002});
        water = scene.add(liquid, places(1 + dx / 2), dx);
        Soil skeleton{{.density = rho,
                       .sound_speed = sph::sound_speed_of(modulus, 0, rho),
                       .shear_modulus = sph::shear_modulus_of(modulus, 0)}};
        skeleton.set(sph::PorousSkeletonParameters{.porosity = n});
        skeleton.set(LoadParameters{.pressure = load});
        const auto soil = scene.add(skeleton, places(1), dx);
        scene.template coupling<InSoil>().set(
            sph::DarcyDragParameters{.permeability = c * (1 / modulus + n / bulk) * liquid.viscosity});
        sph::fill_pores(scene, water, soil);
        const auto all = scene[water];
        for (int i = 0; i < all.size(); ++i) { // the load is on it
            all[sph::density](i) *= 1 + load / bulk;
            all[sph::mass](i) *= 1 + load / bulk;
        }
    }
    static std::array<double, dim> sides(double dx) {
        std::array<double, dim> length{};
        if (dim == 2)
            length[0] = 8 * dx;
        return length;
    }
    /// How far particle i is from the middle of the layer, or of the ball, m.
    double depth(int i) const {
        const auto x = scene[water][sph::position].row(i);
        return dim == 2 ? std::abs(x[1]) : x.norm();
    }
    /// The mean pressure over the load, of what is less than `within` from the middle.
    double pressure(double within) const {
        const auto p = scene[water][sph::pore_pressure];
        double sum = 0;
        int count = 0;
        for (int i = 0; i < p.size(); ++i)
            if (depth(i) < within) {
                sum += p(i) / load;
                ++count;
            }
        return sum / count;
    }
};

inline std::vector<Measured> measure_layer(int across) {
    Body<2> body(across);
    std::vector<Measured> found;
    const double times[]{0.05, 0.1, 0.2, 0.5, 0.848}, known[]{0.2523, 0.3568, 0.5041, 0.7640, 0.9000},
        middle[]{0, 0.9493, 0.7723, 0.3708, 0};
    for (std::size_t k = 0; k < 5; ++k) {
        body.scene.run_until(times[k] / body.c);
        found.push_back({sph::text("U at T = ", times[k]), "2 %", 1 - body.pressure(1), known[k]});
        if (middle[k] > 0)
            found.push_back(
                {sph::text("p in the middle at T = ", times[k]), "2 %", body.pressure(1.2 * body.dx), middle[k]});
    }
    return found;
}

inline std::vector<Measured> measure_ball(int across) {
    Body<3> body(across);
    std::vector<Measured> found;
    const double times[]{0.02, 0.05, 0.1, 0.2}, known[]{1.3582, 1.5573, 1.4755, 0.9972};
    double peak = 0, at = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const double begin = k > 0 ? times[k - 1] : 0;
        for (int part = 1; part <= 10; ++part) {
            const double T = begin + part * (times[k] - begin) / 10;
            body.scene.run_until(T / body.c);
            if (const double p = body.pressure(1.2 * body.dx); p > peak) {
                peak = p;
                at = T;
            }
        }
        found.push_back(
            {sph::text("p in the middle at T = ", times[k]), "3 %", body.pressure(1.2 * body.dx), known[k]});
    }
    found.push_back({"greatest p in the middle", "3 %", peak, 1.575});
    found.push_back({"its T", "none given", at, 0.062});
    return found;
}

} // namespace validation::biot
