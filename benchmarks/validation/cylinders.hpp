// Creeping flow through a square array of cylinders, driven by a body force.
//
// Reference: Sangani and Acrivos (1982), the drag of a cylinder F/(mu U) for solid fractions c, with U averaged over
// the whole cell; for a radius of 0.2 L a boundary integral solution. The array conducts alike in all directions.
// Geometry: one cell of side L, periodic, with the cylinder in it; fluid and cylinder share one square lattice. Where
// its centre lies between the lattice's points is chosen so that the cylinder takes its share c of them.
// Scheme: MorrisViscosity with NoSlipVelocity and NoSlipViscosity at the cylinder, PressureExtrapolation in it. L and
// nu are 1 and sound is 100 nu/L: its step is then about as long as that of viscosity, H/dx = 3, L/dx = 50.
// Measure: F/(mu U) = rho f L^2/(mu U), once U has stopped growing; Re = U L/nu is below 0.01.
#pragma once

#include "sticky_walls.hpp"

#include <imbibe/accuracy/study.hpp>
#include <imbibe/fluid/density_diffusion.hpp>

#include <numbers>

namespace validation::cylinders {

template <class K>
struct Liquid : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::DensityDiffusion<K>, sph::VolumePressure<K>,
                           sph::MorrisViscosity<K>> {};
struct Cylinder : sph::Wall<> {};
template <class K>
struct Contact : sph::Coupling<Liquid<K>, Cylinder, sph::Into<Cylinder, sph::PressureExtrapolation<K>>,
                               sph::VolumePressure<K>, sph::Into<Liquid<K>, sph::VolumeContinuity<K>>,
                               sph::Into<Cylinder, sph::NoSlipVelocity<K>>, sph::NoSlipViscosity<K>> {};
template <class K, class Real>
using Scene = sph::Solver<2, Real, sph::SymplecticEuler, Liquid<K>, Cylinder, Contact<K>>;
using Points = std::vector<sph::Point<2>>;

/// The points of the lattice in the cylinder and round it.
struct Cell {
    Points liquid, cylinder;
};
inline Cell cell(int across, double fraction) {
    const double spacing = 1.0 / across, radius = std::sqrt(fraction / std::numbers::pi);
    const Points all = sph::fill(sph::Box<2>{{0, 0}, {1, 1}}, spacing);
    Cell best;
    double least = 2;
    for (int k = 0; k < 64; ++k) {
        const sph::Point<2> centre(0.5 + k % 8 * spacing / 16, 0.5 + k / 8 * spacing / 16);
        Cell now;
        for (const auto& x : all)
            ((x - centre).norm() < radius ? now.cylinder : now.liquid).push_back(x);
        const double off = std::abs(static_cast<double>(now.cylinder.size()) * spacing * spacing - fraction);
        if (off < least) {
            least = off;
            best = now;
        }
    }
    return best;
}

/// What a run shows.
struct Flow {
    double drag;             ///< F/(mu U)
    double pair_evaluations; ///< the work, see imbibe::accuracy
};

/// F/(mu U) for a solid fraction c, with the force at an angle to the rows of cylinders.
/// @tparam K the kernel, @param support in spacings
template <class K = sph::QuinticSpline, class Real = double>
Flow flow(int across, double fraction, double degrees = 0, double support = 3) {
    const double spacing = 1.0 / across, H = support * spacing, force = 0.1, angle = degrees * std::numbers::pi / 180;
    const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
    Scene<K, Real> scene({.gravity = {force * along[0], force * along[1]},
                          .support_radius = H,
                          .periodic_length = {1, 1},
                          .threads = 1});
    const Cell points = cell(across, fraction);
    Liquid<K> liquid{{.density = 1, .sound_speed = 100, .viscosity = 1}};
    liquid.set(sph::DensityDiffusionParameters{.hydrostatic = false}); // the pressure is periodic
    const auto fluid = scene.add(liquid, points.liquid, spacing);
    scene.add(Cylinder{{.density = 1}}, points.cylinder, spacing);
    const auto mean_velocity = [&] {
        const Eigen::RowVector2d sum = scene[fluid][sph::velocity].template cast<double>().colwise().sum();
        return sum.dot(along) * spacing * spacing;
    };
    // The slowest to start is the thinnest array, with about exp(-15 t): what is missing at the end is below 0.1 %.
    double U = 0;
    for (double end = 0.02, before = -1; std::abs(U - before) > 3e-4 * U || U <= 0; end += 0.02) {
        before = U;
        scene.run_until(end);
        U = mean_velocity();
    }
    return {force / U, sph::accuracy::pair_evaluations(scene)};
}

struct Known {
    double fraction, drag;
    const char* name;
};
inline std::vector<Measured> measure(int across) {
    const Known arrays[]{{.05, 15.56, "c = 0.05"},
                         {.10, 24.83, "c = 0.10"},
                         {.20, 51.53, "c = 0.20"},
                         {.30, 102.90, "c = 0.30"},
                         {.04 * std::numbers::pi, 30.359, "radius 0.2 L"}};
    std::vector<Measured> found;
    for (const Known& a : arrays)
        found.push_back({sph::text("F/(mu U), ", a.name), "3 % at 50", flow(across, a.fraction).drag, a.drag});
    found.push_back({"F/(mu U), c = 0.20, driven at 45 degrees", "3 % at 50", flow(across, .20, 45).drag, 51.53});
    return found;
}

} // namespace validation::cylinders
