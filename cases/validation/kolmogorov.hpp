// Flow that a force sin(2 pi y) drives through a periodic square (Kolmogorov), under a pressure that all of it has.
//
// Reference: exact; the force nu k^2 U sin(k y), k = 2 pi, keeps the velocity U sin(k y), whatever the pressure is.
// Geometry: L = U = rho U^2 = 1, Re = 100, a square lattice that is jittered by a fifth of a spacing. Sound is 20 U.
// Scheme: WeaklyCompressible, and CorrectedGradients, with MorrisViscosity; Wendland C2 of 3 spacings.
// Measure: the viscosity that the flow has from t = 2.5 to 5, from the force and the amplitude A of sin(k y) in the
// velocity: (nu k^2 U - dA/dt)/(k^2 A), over nu.
#pragma once

#include "case.hpp"

#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/methods/corrected_gradients.hpp>
#include <imbibe/methods/weakly_compressible.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <cmath>
#include <numbers>
#include <type_traits>
#include <vector>

namespace validation::kolmogorov {

namespace sph = imbibe;

using K = sph::WendlandC2;
constexpr double wave_number = 2 * std::numbers::pi, nu = 0.01, sound = 20;

/// dv_a/dt = nu k^2 sin(k y_a) along x.
struct Drive : sph::NotStiff {
    using reads = sph::Fields<sph::position>;
    using adds = sph::Fields<sph::acceleration>;

    constexpr auto operator()(const auto& a) const {
        constexpr int dim = std::remove_cvref_t<decltype(a)>::dimension;
        using T = typename std::remove_cvref_t<decltype(a)>::Scalar;
        auto force = sph::Vector<T, dim>::zero();
        const T y = a[sph::position][1];
        if (!std::is_constant_evaluated()) // the library's dry run, at compile time
            force[0] = T(nu * sph::sq(wave_number) * std::sin(wave_number * static_cast<double>(y)));
        return force;
    }
};

struct Plain : sph::Fluid<sph::LinearState, sph::WeaklyCompressible<K>, sph::MorrisViscosity<K>, Drive> {};
struct Corrected : sph::Fluid<sph::LinearState, sph::CorrectedGradients<K>, sph::MorrisViscosity<K>, Drive> {};

/// One run.
struct Run {
    double across = 32;  ///< particles along a side
    double pressure = 0; ///< of all the fluid, rho U^2
    double end = 5;      ///< L/U
};
/// What is seen of it.
struct Seen {
    double viscosity = 0;   ///< over nu
    double off_density = 0; ///< (rho - mean rho)/mean rho at the end, root mean square
};

/// @tparam Liquid Plain or Corrected
template <class Liquid, int dim = 2>
Seen flow(const Run& run) {
    using Point = sph::Point<dim>;
    const double spacing = 1 / run.across, density = 1 + run.pressure / sph::sq(sound);
    sph::Settings<dim> settings{.support_radius = 3 * spacing, .cfl = 0.4, .threads = 1};
    Point size = Point::Constant(1);
    if constexpr (dim == 3)
        size[2] = 8 * spacing;
    for (int d = 0; d < dim; ++d)
        settings.periodic_length[static_cast<std::size_t>(d)] = size[d];
    sph::Solver<dim, double, sph::SymplecticEuler, Liquid> scene(settings);
    const auto places = sph::jitter<dim>(sph::fill(sph::Box<dim>{Point::Zero(), size}, spacing), 0.2 * spacing, 1);
    const auto oil =
        scene.add(Liquid{{.density = 1, .sound_speed = sound, .viscosity = nu * density}}, places, spacing);
    const auto at_start = scene[oil];
    for (int i = 0; i < at_start.size(); ++i) { // the pressure is in the density; the volumes fill the box
        at_start[sph::velocity](i, 0) = std::sin(wave_number * at_start[sph::position](i, 1));
        at_start[sph::density](i) *= density;
        at_start[sph::mass](i) *= density;
    }
    Seen seen;
    double begun = 0, first = 0, last = 0, sum = 0;
    int times = 0;
    scene.run_until(run.end, [&](const auto& s) {
        if (s.time() < run.end / 2)
            return;
        const auto view = s[oil];
        last = 0;
        for (int i = 0; i < view.size(); ++i)
            last += 2 * view[sph::velocity](i, 0) * std::sin(wave_number * view[sph::position](i, 1)) / view.size();
        if (times++ == 0)
            begun = s.time(), first = last;
        sum += last;
    });
    const double square = sph::sq(wave_number);
    seen.viscosity = (nu * square - (last - first) / (scene.time() - begun)) / (square * sum / times) / nu;
    const auto view = scene[oil];
    for (int i = 0; i < view.size(); ++i)
        seen.off_density += sph::sq(view[sph::density](i) / density - 1) / view.size();
    seen.off_density = std::sqrt(seen.off_density);
    return seen;
}

inline std::vector<Measured> measure(int across) {
    std::vector<Measured> found;
    for (const double pressure : {0.0, 1.0, 10.0, 100.0}) {
        const Run run{.across = double(across), .pressure = pressure};
        found.push_back({sph::text("viscosity over nu, p = ", pressure), "2 % to p = 10, 6 % at 100 with 32",
                         flow<Corrected>(run).viscosity, 1});
        found.push_back({sph::text("viscosity over nu, p = ", pressure, ", WeaklyCompressible"), "none given",
                         flow<Plain>(run).viscosity, 1});
    }
    return found;
}

} // namespace validation::kolmogorov
