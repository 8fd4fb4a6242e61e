// A plate that is held at one end and started with the velocity of its first mode.
//
// Reference: plane elasticity by finite elements: a period of 0.2552 s with a rigid root, 0.2623 s where the root is
// held from above and below only, as Gray, Monaghan and Swift did.
// Geometry: Gray, Monaghan and Swift (2001): 0.2 x 0.02 m, 1000 kg/m^3, 2e6 Pa, nu = 0.3975; particles that are held
// beyond x = 0, more columns than a free one can see; or, for the other root, three rows on each side of 0.06 m of
// plate that is as free there as the rest. V_f = 0.01: the end goes 0.02 m to either side.
// Scheme: St. Venant-Kirchhoff, total Lagrangian, Wendland C2 of 1.5 spacings, no damping; or any other solid. All
// but "as it is" has the modulus of `bending_modulus`.
// Measure: the mean period, and how much the greatest deflection of the last period has lost on that of the first.
#pragma once

#include "solid.hpp"

#include <imbibe/accuracy/study.hpp>
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/geometry/combine.hpp>
#include <imbibe/kernels/cubic_spline.hpp>
#include <imbibe/solid/artificial_stress.hpp>
#include <imbibe/solid/jaumann_stress.hpp>
#include <imbibe/solid/stress_force.hpp>
#include <imbibe/solid/velocity_gradient.hpp>
#include <imbibe/state/linear_state.hpp>

namespace validation::oscillating_plate {

constexpr double length = 0.2;        // m
constexpr double young_modulus = 2e6; // Pa

/// The solid of the paper's kind: rates of stress, from the present neighbours, with artificial viscosity and stress.
/// `alpha` in terms of the support radius.
struct RatePlate
    : sph::Solid<sph::LinearState, sph::Continuity<sph::CubicSpline>, sph::VelocityGradient<sph::CubicSpline>,
                 sph::JaumannStress, sph::StressForce<sph::CubicSpline>, sph::MonaghanViscosity<sph::CubicSpline>,
                 sph::ArtificialStress<sph::CubicSpline, sph::PrincipalAxes, sph::CubicSpline>, sph::Clamped> {};

/// What holds the plate beyond x = 0.
enum class Root { rigid, between_rows };

/// One run: how fine, how far, how long.
struct Run {
    int across;           ///< particles over the thickness
    double support_ratio; ///< support radius in spacings
    int periods;
    double V_f = 0.01;       ///< the first speed of the end in terms of the speed of sound
    double thickness = 0.02; ///< m
    Root root = Root::rigid;
    double cfl = 0.4; ///< share of the shortest limit that a step takes
};

/// The first mode of a cantilever, 1 at x = L (Landau and Lifshitz); nothing in the root.
inline double first_mode(double x) {
    const double kL = 1.8751040687;
    const auto f = [&](double z) {
        return (std::cos(kL) + std::cosh(kL)) * (std::cosh(z) - std::cos(z)) +
               (std::sin(kL) - std::sinh(kL)) * (std::sinh(z) - std::sin(z));
    };
    return x > 0 ? f(kL * x / length) / f(kL) : 0;
}

/// What a run shows.
struct Swings {
    std::vector<double> upward;  ///< times at which the tip passes its rest position upwards, s
    std::vector<double> peaks;   ///< greatest deflection of the tip between them, m
    double pair_evaluations = 0; ///< the work, see imbibe::accuracy
    double period() const { return upward.back() / static_cast<double>(peaks.size()); } ///< the mean one, s
};

/// @tparam Integrator of the scene
/// @tparam Plate ElasticPlate, RatePlate, or another solid that can be clamped
template <class Integrator = sph::SymplecticEuler, class Plate>
Swings swing(const Plate& material, const Run& run) {
    const double spacing = run.thickness / run.across;
    sph::Solver<2, double, Integrator, Plate> scene(
        {.support_radius = run.support_ratio * spacing, .cfl = run.cfl, .threads = 1});
    const bool rigid = run.root == Root::rigid;
    const double root = rigid ? std::ceil(2 * run.support_ratio) * spacing : 0.06; // more than a particle can see
    const double face = run.thickness / 2, rows = rigid ? 0 : 3 * spacing;
    const auto points = sph::fill(
        sph::Box<2>{{-root, -face}, {length, face}} | sph::Box<2>{{-root, -face - rows}, {0, face + rows}}, spacing);
    const auto plate = scene.add(material, points, spacing);
    scene.hold(plate, [&](const auto& x) { return x[0] < 0 && (rigid || std::abs(x[1]) > face); });
    auto view = scene[plate];
    for (int i = 0; i < view.size(); ++i)
        view[sph::velocity](i, 1) = run.V_f * material.sound_speed * first_mode(view[sph::position](i, 0));
    const EndProbe end(view, run.across);
    Swings seen{{0.0}, {}};
    double before = 0, greatest = 0;
    while (static_cast<int>(seen.peaks.size()) < run.periods && scene.time() < run.periods * 0.01 / run.thickness) {
        const double dt = scene.step(), now = end.displacement(view)[1];
        greatest = std::max(greatest, std::abs(now));
        if (before < 0 && now >= 0) {
            seen.upward.push_back(scene.time() - dt * now / (now - before));
            seen.peaks.push_back(greatest);
            greatest = 0;
        }
        before = now;
    }
    seen.pair_evaluations = sph::accuracy::pair_evaluations(scene);
    return seen;
}

/// The rubber of the plate.
template <class Plate>
Plate rubber(double young = young_modulus) {
    return elastic<Plate>(young, 0.3975, 1000);
}

inline std::vector<Measured> measure(int across) {
    const Run run{.across = across, .support_ratio = 1.5, .periods = 10};
    const Swings plain = swing(rubber<ElasticPlate>(), run);
    const Swings seen = swing(rubber<ElasticPlate>(sph::bending_modulus(young_modulus, across)), run);
    Run between_rows = run;
    between_rows.root = Root::between_rows;
    const Swings looser = swing(rubber<ElasticPlate>(sph::bending_modulus(young_modulus, across)), between_rows);
    return {{"period, s, as it is", "2 % at 10", plain.period(), 0.2552},
            {"period, s", "2 % at 10", seen.period(), 0.2552},
            {"period, s, held between rows", "3 %", looser.period(), 0.2623},
            {"deflection in the tenth period, share of the first's", "2 %", seen.peaks.back() / seen.peaks.front(), 1}};
}

} // namespace validation::oscillating_plate
