// Flow between plates, driven by a body force, of liquids whose viscosity depends on the rate of shear.
//
// Reference: exact. The stress at y from the middle is G y, so the rate of shear is gamma(G y) with the law's own
// gamma(tau), and the velocity is its integral from there to the plate: in closed form for Herschel and Bulkley
// ((tau - tau_0)/K)^(1/n), by quadrature for Carreau.
// Geometry: gap, density and force G/2 are 1; 8 spacings long and periodic, square lattice.
// Scheme: GeneralisedNewtonianViscosity, no-slip walls, Wendland C2 of 3 spacings; the start is at rest.
// Measure: the velocity in the middle (mean over the two rows beside it) and the mean velocity at t = 1.5, when nothing
// changes any more.
#pragma once

#include "case.hpp"

#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/generalised_no_slip.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace validation::laws_of_flow {

namespace sph = imbibe;
using K = sph::WendlandC2;

template <class Law>
struct Paste : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>,
                          sph::GeneralisedNewtonianViscosity<Law, K>> {};
struct Plates : sph::Wall<> {};
template <class Law>
struct OnPlates
    : sph::Coupling<Paste<Law>, Plates, sph::Into<Plates, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                    sph::Into<Paste<Law>, sph::VolumeContinuity<K>>, sph::Into<Plates, sph::NoSlipVelocity<K>>,
                    sph::Into<Paste<Law>, sph::NoSlipStrainRate<K>>, sph::NoSlipApparentViscosity<K>> {};

/// Velocities.
struct Profile {
    double middle = 0, mean = 0;
};

constexpr double half_gap = 0.5, force = 2;

/// What must come out of a law. @param rate the rate of shear of a stress
inline Profile exact(const std::function<double(double)>& rate) {
    Profile found;
    constexpr int n = 20000;
    for (int k = 0; k < n; ++k) {
        const double y = half_gap * (k + 0.5) / n, gamma = rate(force * y);
        found.middle += gamma * half_gap / n;
        found.mean += y / half_gap * gamma * half_gap / n;
    }
    return found;
}
/// Without the regularisation at rest.
inline double rate_of(const sph::HerschelBulkleyParameters& p, double stress) {
    return stress > p.yield_stress ? std::pow((stress - p.yield_stress) / p.consistency, 1 / p.exponent) : 0;
}
inline double rate_of(const sph::CarreauParameters& p, double stress) {
    double low = 0, high = 1;
    const auto stress_at = [&](double rate) { return rate * sph::Carreau::viscosity(p, rate); };
    while (stress_at(high) < stress)
        high *= 2;
    for (int k = 0; k < 80; ++k)
        (stress_at(0.5 * (low + high)) < stress ? low : high) = 0.5 * (low + high);
    return low;
}

/// What the particles do, with so many across the gap.
template <class Law>
Profile flow(const typename Law::Parameters& parameters, int across) {
    const double spacing = 2 * half_gap / across, length = 8 * spacing;
    sph::Solver<2, double, sph::SymplecticEuler, Paste<Law>, Plates, OnPlates<Law>> scene(
        {.gravity = {force, 0},
         .support_radius = 3 * spacing,
         .cfl = 0.4,
         .periodic_length = {length, 0},
         .threads = 1});
    const sph::Box<2> between{{0, 0}, {length, 2 * half_gap}};
    Paste<Law> paste{{.density = 1, .sound_speed = 3}};
    paste.set(parameters);
    const auto liquid = scene.add(paste, sph::fill(between, spacing), spacing);
    scene.add(Plates{{.density = 1}}, sph::tank(between, spacing, 3, sph::Sides::x), spacing);
    scene.run_until(1.5);
    Profile found;
    const auto view = scene[liquid];
    int beside = 0;
    for (int i = 0; i < view.size(); ++i) {
        found.mean += view[sph::velocity](i, 0) / view.size();
        if (std::abs(view[sph::position](i, 1) - half_gap) < 0.76 * spacing) {
            found.middle += view[sph::velocity](i, 0);
            ++beside;
        }
    }
    found.middle /= beside;
    return found;
}

constexpr sph::HerschelBulkleyParameters thinning{.consistency = 1, .exponent = 0.5, .least_rate = 0.01},
    thickening{.consistency = 1, .exponent = 1.5}, bingham{.consistency = 1, .yield_stress = 0.3, .sharpness = 100},
    paste{.consistency = 0.7, .exponent = 0.5, .yield_stress = 0.3, .sharpness = 100, .least_rate = 0.01};
constexpr sph::CarreauParameters carreau{.at_rest = 1, .fast = 0.1, .time = 2, .exponent = 0.4};

template <class Law>
void measure_one(std::vector<Measured>& found, const char* name, const typename Law::Parameters& parameters,
                 int across) {
    const Profile seen = flow<Law>(parameters, across),
                  right = exact([&](double stress) { return rate_of(parameters, stress); });
    found.push_back({std::string("velocity in the middle, ") + name, "2 % at 25", seen.middle, right.middle});
    found.push_back({std::string("mean velocity, ") + name, "2 % at 25", seen.mean, right.mean});
}
inline std::vector<Measured> measure(int across) {
    std::vector<Measured> found;
    measure_one<sph::HerschelBulkley>(found, "n = 0.5", thinning, across);
    measure_one<sph::HerschelBulkley>(found, "n = 1.5", thickening, across);
    measure_one<sph::HerschelBulkley>(found, "Bingham", bingham, across);
    measure_one<sph::HerschelBulkley>(found, "n = 0.5 with a yield stress", paste, across);
    measure_one<sph::Carreau>(found, "Carreau", carreau, across);
    return found;
}

} // namespace validation::laws_of_flow
