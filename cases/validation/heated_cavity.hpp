// Air in a square cavity that is warm on the left and cold on the right.
//
// Reference: de Vahl Davis (1983), extrapolated from grids of up to 81 x 81: the mean Nusselt number, the heat that
// crosses the cavity over what it would be at rest, 1.118, 2.243 and 4.519 at Rayleigh numbers of 1e3, 1e4 and 1e5; the
// greatest velocity across x = 0.5 and y = 0.5 in units of kappa/L, 3.649 and 3.697, 16.178 and 19.617, 34.73
// and 68.59.
//
// Geometry: side 1, the walls 1 K apart, floor and lid insulated; Pr = 0.71. The greatest speed that the air would
// reach, sqrt(g beta 1 K L), is 1, and beta 1 K = 1: only g beta counts.
//
// Scheme: that of the cavity with a lid by SummationDensity, with Boussinesq, HeatConduction and EnthalpyAdvection;
// quintic spline of 3 spacings. Sound is 10. From rest, on a lattice jittered by a tenth of a spacing.
//
// Measure: the mean over the last quarter of the heat that both walls take up, and of the velocities on the two lines.
#pragma once

#include "case.hpp"
#include "sticky_walls.hpp"

#include <imbibe/fluid/particle_shifting.hpp>
#include <imbibe/fluid/summation_density.hpp>
#include <imbibe/fluid/transport_advection.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/heat/boussinesq.hpp>
#include <imbibe/heat/conduction.hpp>
#include <imbibe/heat/enthalpy_advection.hpp>
#include <imbibe/heat/heat_capacity.hpp>
#include <imbibe/heat/surface_temperature.hpp>
#include <imbibe/monitor/energy.hpp>
#include <imbibe/monitor/value_at.hpp>

namespace validation::heated_cavity {

using K = sph::QuinticSpline;
template <class... More>
using AirWith = sph::Fluid<sph::LinearState, sph::SummationDensity<K>, sph::VolumePressure<K>, sph::MorrisViscosity<K>,
                           sph::ParticleShifting<K>, sph::TransportAdvection<K>, sph::HeatCapacity,
                           sph::HeatConduction<K>, sph::Boussinesq, More...>;
struct Air : AirWith<sph::EnthalpyAdvection<K>> {};
struct TakenAlong : AirWith<> {};
struct Insulated : sph::Wall<> {};
template <int>
struct Heated : sph::Wall<sph::SurfaceTemperature> {};
template <class Gas, class Side, class... More>
struct At
    : sph::Coupling<Gas, Side, sph::Into<Side, sph::PressureExtrapolation<K>>,
                    sph::Into<Side, sph::BoussinesqExtrapolation<K>>, sph::VolumePressure<K>,
                    sph::Into<Side, sph::NoSlipVelocity<K>>, sph::NoSlipViscosity<K>,
                    sph::Into<Gas, sph::SummationNeighbours<K>>, sph::Into<Gas, sph::ShiftingNeighbours<K>>, More...> {
};
template <class Gas, class Side>
struct Warming : At<Gas, Side, sph::Into<Side, sph::TemperatureExtrapolation<K>>, sph::HeatTransfer<K>> {};
template <class Gas>
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Gas, Insulated, Heated<0>, Heated<1>, At<Gas, Insulated>,
                          Warming<Gas, Heated<0>>, Warming<Gas, Heated<1>>>;

/// What is seen of it.
struct Seen {
    double nusselt = 0;           ///< mean of both walls
    double across = 0, along = 0; ///< greatest u on x = 0.5 and v on y = 0.5, kappa/L
};

/// @tparam Gas Air, or TakenAlong: without EnthalpyAdvection
template <class Gas>
Seen convect(int particles, double Ra, double end) {
    const double spacing = 1.0 / particles, Pr = 0.71, kappa = 1 / std::sqrt(Ra * Pr);
    Scene<Gas> scene({.gravity = {0, -1}, .support_radius = 3 * spacing, .cfl = 0.7, .threads = 1});
    const sph::Box<2> inside{{0, 0}, {1, 1}};
    Gas air{{.density = 1, .sound_speed = 10, .viscosity = Pr * kappa}};
    air.set(sph::HeatParameters{.heat_capacity = 1, .heat_conductivity = kappa, .reference_temperature = 0});
    air.set(sph::BoussinesqParameters{.thermal_expansion = 1, .neutral_temperature = 0});
    const auto cell = scene.add(air, sph::jitter<2>(sph::fill(inside, spacing), 0.1 * spacing, 1), spacing);
    std::vector<sph::Point<2>> sides[3];
    for (const auto& x : sph::tank(inside, spacing, 3))
        sides[x[1] < 0 || x[1] > 1 ? 0 : x[0] < 0 ? 1 : 2].push_back(x);
    scene.add(Insulated{{.density = 1}}, sides[0], spacing);
    Heated<0> left{{.density = 1}};
    left.set(sph::SurfaceTemperatureParameters{.surface_temperature = 0.5});
    Heated<1> right{{.density = 1}};
    right.set(sph::SurfaceTemperatureParameters{.surface_temperature = -0.5});
    const auto warm = scene.add(left, sides[1], spacing);
    const auto cold = scene.add(right, sides[2], spacing);

    Seen seen;
    const auto taken = [&] { return sph::thermal_energy(scene[cold]) - sph::thermal_energy(scene[warm]); };
    double before = 0, begun = 0;
    constexpr int samples = 40, places = 64;
    Eigen::ArrayXd u = Eigen::ArrayXd::Zero(places), v = u;
    for (int n = 0; n <= samples; ++n) {
        scene.run_until(end * (0.75 + 0.25 * n / samples));
        if (n == 0) {
            before = taken();
            begun = scene.time();
            continue;
        }
        for (int k = 0; k < places; ++k) {
            const double at = (k + 0.5) / places;
            u[k] += sph::value_at(scene, cell, sph::velocity, {0.5, at})[0] / samples;
            v[k] += sph::value_at(scene, cell, sph::velocity, {at, 0.5})[1] / samples;
        }
    }
    seen.nusselt = 0.5 * (taken() - before) / (scene.time() - begun) / kappa;
    seen.across = u.maxCoeff() / kappa;
    seen.along = v.maxCoeff() / kappa;
    return seen;
}

inline std::vector<Measured> measure(int particles) {
    struct Known {
        double Ra, end, nusselt, across, along;
    };
    std::vector<Measured> found;
    for (const Known& known : {Known{1e3, 20, 1.118, 3.649, 3.697}, Known{1e4, 40, 2.243, 16.178, 19.617},
                               Known{1e5, 80, 4.519, 34.73, 68.59}}) {
        const Seen seen = convect<Air>(particles, known.Ra, known.end);
        const auto at = sph::text(", Ra = ", known.Ra);
        found.push_back({"Nusselt number" + at, "2 %", seen.nusselt, known.nusselt});
        if (known.Ra == 1e4)
            found.push_back({"Nusselt number" + at + ", without EnthalpyAdvection", "none given",
                             convect<TakenAlong>(particles, known.Ra, known.end).nusselt, known.nusselt});
        found.push_back({"greatest u on x = 0.5, kappa/L" + at, "none given", seen.across, known.across});
        found.push_back({"greatest v on y = 0.5, kappa/L" + at, "none given", seen.along, known.along});
    }
    return found;
}

} // namespace validation::heated_cavity
