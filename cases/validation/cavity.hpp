// Flow in a square cavity that its lid drives.
//
// Reference: the least u on the line x = 0.5, the greatest and the least v on y = 0.5. At Re = 100 -0.21404, 0.17957,
// -0.25380 (Marchi, Suero and Araki 2009, extrapolated from 1024 x 1024 cells), at Re = 1000 -0.38857, 0.37694,
// -0.52708 (Botella and Peyret 1998, spectral). The mostly cited ones of Ghia, Ghia and Shin (1982) are 1.5 to 3.3 %
// nearer to zero.
//
// Geometry: side 1, lid speed 1, nu = 1/Re; walls of three layers on all sides, of which the upper ones move.
//
// Scheme: quintic spline of 3 spacings, MorrisViscosity and SummationDensity, which cannot drift; or Wendland C2 of 3
// spacings with corrected gradients and density diffusion; in both, shifting and TransportAdvection. The walls count as
// neighbours in all sums but those of the latter. Sound is 10. From rest, on a lattice jittered by a tenth of a
// spacing.
//
// Measure: the mean over the last fifth of 15 (Re = 1000: 60) of the velocities on the two lines, by moving least
// squares of first order over the particles within H.
#pragma once

#include "case.hpp"
#include "sticky_walls.hpp"

#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/particle_shifting.hpp>
#include <imbibe/fluid/summation_density.hpp>
#include <imbibe/fluid/transport_advection.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/monitor/value_at.hpp>
#include <imbibe/wall/corrected_no_slip.hpp>

namespace validation::cavity {

using K = sph::QuinticSpline;
struct Oil : sph::Fluid<sph::LinearState, sph::SummationDensity<K>, sph::VolumePressure<K>, sph::MorrisViscosity<K>,
                        sph::ParticleShifting<K>, sph::TransportAdvection<K>> {};
struct Walls : sph::Wall<> {};
template <class Liquid>
struct OnWalls
    : sph::Coupling<Liquid, Walls, sph::Into<Walls, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                    sph::Into<Walls, sph::NoSlipVelocity<K>>, sph::NoSlipViscosity<K>,
                    sph::Into<Liquid, sph::SummationNeighbours<K>>, sph::Into<Liquid, sph::ShiftingNeighbours<K>>> {};

using C2 = sph::WendlandC2;
struct CorrectedOil : sph::Fluid<sph::LinearState, sph::CurrentCorrection<C2>, sph::CorrectedContinuity<C2>,
                                 sph::DensityDiffusion<C2>, sph::CorrectedPressure<C2>, sph::CorrectedViscosity<C2>,
                                 sph::ParticleShifting<C2>, sph::TransportAdvection<C2>> {};
template <>
struct OnWalls<CorrectedOil>
    : sph::Coupling<CorrectedOil, Walls, sph::Into<Walls, sph::PressureExtrapolation<C2>>, sph::CorrectedPressure<C2>,
                    sph::Into<Walls, sph::NoSlipVelocity<C2>>, sph::CorrectedNoSlipViscosity<C2>,
                    sph::Into<CorrectedOil, sph::CorrectedContinuity<C2>>,
                    sph::Into<CorrectedOil, sph::CorrectionNeighbours<C2>>,
                    sph::Into<CorrectedOil, sph::ShiftingNeighbours<C2>>> {};

struct Lines {
    double least_u, greatest_v, least_v; ///< shares of the lid's speed
    double lightest = 0, densest = 0;    ///< density in the end
};
/// The references.
constexpr Lines at_100{-0.21404, 0.17957, -0.25380}, at_1000{-0.38857, 0.37694, -0.52708};

/// @param material an Oil or a CorrectedOil with its coefficients; density, sound and viscosity are set here
template <class Liquid>
Lines drive(int across, double end, double Re = 100, Liquid material = {}) {
    const double spacing = 1.0 / across, H = 3 * spacing;
    sph::Solver<2, double, sph::SymplecticEuler, Liquid, Walls, OnWalls<Liquid>> scene(
        {.support_radius = H, .cfl = 0.4, .threads = 1});
    const sph::Box<2> inside{{0, 0}, {1, 1}};
    material.density = 1;
    material.sound_speed = 10;
    material.viscosity = 1 / Re;
    const auto liquid = scene.add(material, sph::jitter<2>(sph::fill(inside, spacing), 0.1 * spacing, 1), spacing);
    const auto oil = scene[liquid];
    auto walls = scene[scene.add(Walls{{.density = 1}}, sph::tank(inside, spacing, 3), spacing)];
    for (int i = 0; i < walls.size(); ++i)
        walls[sph::velocity](i, 0) = walls[sph::position](i, 1) > 1 ? 1 : 0;

    constexpr int places = 64;
    Eigen::ArrayXd u = Eigen::ArrayXd::Zero(places), v = u;
    constexpr int samples = 40;
    for (int n = 0; n < samples; ++n) {
        scene.run_until(end * (0.8 + 0.2 * (n + 1) / samples));
        for (int k = 0; k < places; ++k) {
            const double at = (k + 0.5) / places;
            u[k] += sph::value_at(scene, liquid, sph::velocity, {0.5, at})[0] / samples;
            v[k] += sph::value_at(scene, liquid, sph::velocity, {at, 0.5})[1] / samples;
        }
    }
    return {u.minCoeff(), v.maxCoeff(), v.minCoeff(), oil[sph::density].minCoeff(), oil[sph::density].maxCoeff()};
}

/// What both schemes show beside the reference.
inline std::vector<Measured> compared(int across, double end, double Re, const char* asked, const Lines& known) {
    std::vector<Measured> found;
    for (const bool corrected : {false, true}) {
        const Lines lines = corrected ? drive<CorrectedOil>(across, end, Re) : drive<Oil>(across, end, Re);
        const auto name = sph::text(Re > 100 ? ", Re = 1000" : "", corrected ? ", corrected gradients" : "");
        found.push_back({"least u on x = 0.5" + name, asked, lines.least_u, known.least_u});
        found.push_back({"greatest v on y = 0.5" + name, asked, lines.greatest_v, known.greatest_v});
        found.push_back({"least v on y = 0.5" + name, asked, lines.least_v, known.least_v});
    }
    return found;
}

inline std::vector<Measured> measure(int across) {
    return compared(across, 15, 100, "2 % at 50", at_100);
}

inline std::vector<Measured> measure_faster(int across) {
    return compared(across, 60, 1000, "none given", at_1000);
}

} // namespace validation::cavity
