// A layer of wet soil is loaded, and the water in its pores carries the load until it has drained.
//
// Reference: Terzaghi's one-dimensional consolidation: the degree of consolidation, 1 - the mean pore pressure over
// that at the start, is 0.25231, 0.50034, 0.76395 and 0.89998 at T = c_v t/H^2 = 0.05, 0.197, 0.5 and 0.848. Geometry:
// plane, periodic to the sides; a layer of 2 H = 1 m between drained rows, three above, which bear the load, and three
// below, which are held. Scheme: the library has no such solid; it is one of three terms that stand here. A
// total-Lagrangian skeleton without Poisson's effect, whose pores are full of water of the content zeta (what has
// flowed in, of the volume): its pressure is p = M (zeta - (J - 1)), its share in the stress -p J F^-T (Biot 1941,
// incompressible grains), and it flows as Darcy says, dzeta/dt = k/mu Laplacian(p). Quintic spline of 3 spacings. M is
// Young's modulus E, c_v = k/mu E M/(E + M). It starts with the strain and the pressure of the load with nothing
// drained yet, and is damped. Measure: the mean of p over the layer.
#pragma once

#include "case.hpp"

#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/kernels/kernels.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <algorithm>
#include <numbers>
#include <tuple>

namespace validation::consolidation {

namespace sph = imbibe;
using K = sph::QuinticSpline;

/// What has flowed into the pores, as a share of the volume.
struct WaterContent : sph::Field<sph::Rank::scalar> {
    static constexpr std::string_view name = "water_content", unit = "1";
    static constexpr std::string_view rate_name = "water_content_rate", rate_unit = "1/s";
};
inline constexpr WaterContent water_content{};
inline constexpr sph::Rate<WaterContent> water_content_rate{};
/// Pressure of the water in the pores, Pa.
struct PorePressure : sph::Field<sph::Rank::scalar> {
    static constexpr std::string_view name = "pore_pressure", unit = "Pa";
};
inline constexpr PorePressure pore_pressure{};
/// 1 where the pores are the soil's, 0 where they are open to the air, which keeps their pressure at zero.
struct Closed : sph::Field<sph::Rank::scalar> {
    static constexpr std::string_view name = "closed", unit = "1";
    static constexpr bool given = true;
};
inline constexpr Closed closed{};

inline constexpr double young = 1e6, water_modulus = young, conductivity = 8e-8, density = 1000; // Pa, Pa, m^2/(Pa s)
inline constexpr double height = 1, load = 100;                                                  // m, Pa

/// Lets rows of a phase be open.
struct Drainage {
    using stores = sph::Fields<closed>;
};

/// Stress of the skeleton and of the water in its pores.
struct WetSkeleton {
    static constexpr bool of_solids = true;
    using reads = sph::Fields<sph::deformation_gradient, water_content, closed>;
    using sets = sph::Fields<sph::first_piola_stress, pore_pressure>;

    constexpr auto operator()(const auto& a) const {
        using T = typename std::remove_cvref_t<decltype(a)>::Scalar;
        const auto F = a[sph::deformation_gradient];
        const T p = a[closed] * T(water_modulus) * (a[water_content] - (determinant(F) - T(1)));
        return std::tuple(sph::StVenantKirchhoff{}(a)-p * transpose(adjugate(F)), p); // J F^-T
    }
};

/// dzeta_a/dt = 2 k/mu sum_b V_b (p_a - p_b) F_ab, grad_a W_ab = F_ab X_ab. Source: Brookshaw (1985).
struct Darcy {
    using neighbourhood = sph::Reference;
    using reads = sph::Fields<sph::mass, pore_pressure>;
    using adds = sph::Fields<water_content_rate>;

    constexpr auto operator()(const auto& a, const auto& b, const auto& ab) const {
        return (2 * conductivity / b.material.density) * b[sph::mass] * (a[pore_pressure] - b[pore_pressure]) *
               ab.gradient(K{});
    }
};

struct Soil : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, Drainage, WetSkeleton, Darcy,
                         sph::TotalLagrangianForce<K>, sph::TotalLagrangianViscosity<K>, sph::Clamped> {};

/// Degrees of consolidation at these dimensionless times. @param across particles over the layer
inline std::vector<double> degrees(int across, const std::vector<double>& times) {
    const double dx = height / across, rows = 3 * dx, wide = 10 * dx;
    sph::Solver<2, double, sph::SymplecticEuler, Soil> scene(
        {.support_radius = 3 * dx, .periodic_length = {wide, 0}, .threads = 1});
    Soil material{{.density = density,
                   .sound_speed = sph::sound_speed_of(young, 0, density),
                   .shear_modulus = sph::shear_modulus_of(young, 0)}};
    material.set(sph::TotalLagrangianViscosityParameters{.alpha = 0.5});
    const auto soil = scene.add(material, sph::fill(sph::Box<2>{{0, -rows}, {wide, height + rows}}, dx), dx);
    scene.hold(soil, [&](const auto& x) { return x[1] < 0; });
    const double strain = -load / (young + water_modulus), dry_strain = -load / young;
    {
        auto view = scene[soil];
        for (int i = 0; i < view.size(); ++i) {
            const double y = view[sph::position](i, 1);
            view[closed](i) = y > 0 && y < height ? 1 : 0;
            view[sph::position](i, 1) += strain * std::clamp(y, 0.0, height) + dry_strain * std::max(0.0, y - height);
        }
    }
    scene.prepare();
    const double wave = std::sqrt((young + water_modulus) / density), dt = 0.3 * dx / wave;
    const double damping = std::numbers::pi * wave / height, kept = std::exp(-dt * damping); // twice the lowest mode's
    const double c_v = conductivity * young * water_modulus / (young + water_modulus);
    // The rows that are drained have no pressure from the first one on.
    const double path = (height + dx) / 2;
    std::vector<double> found;
    for (const double T : times) {
        while (scene.time() * c_v < T * path * path) {
            auto view = scene[soil];
            for (int i = 0; i < view.size(); ++i)
                if (view[sph::reference_position](i, 1) > height + rows - dx) // the uppermost row
                    view[sph::velocity](i, 1) -= dt * load / (density * dx);
            view[sph::velocity] *= kept;
            scene.step(dt);
        }
        const auto view = scene[soil];
        const double start = load * water_modulus / (young + water_modulus);
        found.push_back(1 - view[pore_pressure].col(0).dot(view[closed].col(0)) / view[closed].col(0).sum() / start);
    }
    return found;
}

inline std::vector<Measured> measure(int resolution) {
    const std::vector<double> times{0.05, 0.197, 0.5, 0.848}, exact{0.25231, 0.50034, 0.76395, 0.89998};
    const auto found = degrees(resolution, times);
    std::vector<Measured> all;
    for (std::size_t k = 0; k < times.size(); ++k)
        all.push_back({"degree of consolidation at T = " + std::to_string(times[k]).substr(0, 5), "none given",
                       found[k], exact[k]});
    return all;
}

} // namespace validation::consolidation
