// The start of a flow between two plates: driven by a body force (Poiseuille), or by the upper plate (Couette).
//
// Reference: the series solutions (Morris, Fox and Zhu 1997): velocities in the middle at five times.
// Geometry: gap 1 mm, nu = 1e-6 m^2/s, 8 spacings long and periodic, square lattice; force 1e-4 m/s^2 or an upper plate
// that moves with 1.25e-5 m/s.
// Scheme: MorrisViscosity, NoSlipVelocity and NoSlipViscosity at the plates, with a kernel of choice. What is left with
// many particles is the error of its lattice sum: 0.26 % with 3 spacings of Wendland C2, 0.08 % with the quintic
// spline (Couette's first time, when the middle has 1/27 of its speed yet, apart). Sound is eighty times the greatest
// speed: the viscous limit on the step is the shorter one all the same.
// Measure: the velocity in the middle, that of the polynomial of fourth degree which fits the middle half of the gap
// best.
#pragma once

#include "sticky_walls.hpp"

#include <imbibe/wall/corrected_no_slip.hpp>

#include <Eigen/Cholesky>

#include <array>

namespace validation::plates {

template <class K, class Viscosity = sph::MorrisViscosity<K>>
struct Oil : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::VolumePressure<K>, Viscosity> {};
struct Plates : sph::Wall<> {};
template <class K, class Liquid = Oil<K>>
struct OnPlates : sph::Coupling<Liquid, Plates, sph::Into<Plates, sph::PressureExtrapolation<K>>,
                                sph::VolumePressure<K>, sph::Into<Liquid, sph::VolumeContinuity<K>>,
                                sph::Into<Plates, sph::NoSlipVelocity<K>>, sph::NoSlipViscosity<K>> {};

/// With corrected kernel gradients.
template <class K>
struct CorrectedOil : sph::Fluid<sph::LinearState, sph::CurrentCorrection<K>, sph::CorrectedContinuity<K>,
                                 sph::CorrectedPressure<K>, sph::CorrectedViscosity<K>> {};
template <class K>
struct OnPlates<K, CorrectedOil<K>>
    : sph::Coupling<CorrectedOil<K>, Plates, sph::Into<CorrectedOil<K>, sph::CorrectionNeighbours<K>>,
                    sph::Into<Plates, sph::PressureExtrapolation<K>>, sph::CorrectedPressure<K>,
                    sph::Into<CorrectedOil<K>, sph::CorrectedContinuity<K>>, sph::Into<Plates, sph::NoSlipVelocity<K>>,
                    sph::CorrectedNoSlipViscosity<K>> {};

constexpr double gap = 1e-3, nu = 1e-6;
constexpr std::array<double, 5> times{0.0225, 0.045, 0.1125, 0.225, 1};

/// What drives the flow, and what comes of it in the middle at `times`.
struct Drive {
    double force;                 ///< m/s^2
    double lid;                   ///< speed of the upper plate, m/s
    std::array<double, 5> middle; ///< m/s
};
constexpr Drive poiseuille{1e-4, 0, {2.23274e-6, 4.23457e-6, 8.24991e-6, 11.0998e-6, 12.4993e-6}};
constexpr Drive couette{0, 1.25e-5, {0.230277e-6, 1.19475e-6, 3.62844e-6, 5.38629e-6, 6.24959e-6}};

/// The velocities in the middle at `times`, m/s. @param support H in spacings
/// @tparam Liquid Oil or CorrectedOil
template <class K, class Liquid = Oil<K>>
std::array<double, 5> middle_velocities(const Drive& drive, int across, double support) {
    const double spacing = gap / across, length = 8 * spacing;
    sph::Solver<2, double, sph::SymplecticEuler, Liquid, Plates, OnPlates<K, Liquid>> scene(
        {.gravity = {drive.force, 0},
         .support_radius = support * spacing,
         .cfl = 0.4,
         .periodic_length = {length, 0},
         .threads = 1});
    const sph::Box<2> between{{0, 0}, {length, gap}};
    const auto oil = scene.add(Liquid{{.density = 1000, .sound_speed = 1e-3, .viscosity = 1000 * nu}},
                               sph::fill(between, spacing), spacing);
    const auto plates =
        scene.add(Plates{{.density = 1000}},
                  sph::tank(between, spacing, static_cast<int>(std::ceil(support)), sph::Sides::x), spacing);
    for (int i = 0; i < scene[plates].size(); ++i)
        scene[plates][sph::velocity](i, 0) = scene[plates][sph::position](i, 1) > gap ? drive.lid : 0;

    std::array<double, 5> middle{};
    for (std::size_t k = 0; k < times.size(); ++k) {
        scene.run_until(times[k]);
        const auto view = scene[oil];
        Eigen::Matrix<double, 5, 5> moments = Eigen::Matrix<double, 5, 5>::Zero();
        Eigen::Matrix<double, 5, 1> sums = Eigen::Matrix<double, 5, 1>::Zero();
        for (int i = 0; i < view.size(); ++i) {
            const double y = 4 * (view[sph::position](i, 1) / gap - 0.5); // -1 to 1 in the middle half
            if (std::abs(y) < 1.001) {                                    // a row may lie on its border
                const Eigen::Matrix<double, 5, 1> powers{1, y, y * y, y * y * y, y * y * y * y};
                moments += powers * powers.transpose();
                sums += view[sph::velocity](i, 0) * powers;
            }
        }
        middle[k] = moments.ldlt().solve(sums)(0);
    }
    return middle;
}

inline std::vector<Measured> measure(const Drive& drive, int across) {
    const auto middle = middle_velocities<sph::QuinticSpline>(drive, across, 3);
    std::vector<Measured> found;
    for (std::size_t k = 0; k < times.size(); ++k)
        found.push_back(
            {sph::text("velocity in the middle at ", times[k], " s, m/s"), "0.7 % at 50", middle[k], drive.middle[k]});
    return found;
}
inline std::vector<Measured> measure_poiseuille(int across) {
    return measure(poiseuille, across);
}
inline std::vector<Measured> measure_couette(int across) {
    return measure(couette, across);
}

} // namespace validation::plates
