// The permeability and tortuosity of a porous body, from slow flow between particles.
#pragma once

#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/combine.hpp>
#include <imbibe/geometry/fitted.hpp>
#include <imbibe/kernels/quintic_spline.hpp>
#include <imbibe/porous/cell.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/no_slip.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace imbibe {

/// The results of permeability() for one direction.
struct Permeability {
    /// k_x, k_y, k_z, m^2: a column of the permeability tensor, for a pressure gradient along one axis.
    Point<3> column;
    /// Of the component along that axis, m^2: the expected change with a finer spacing; 0: not known.
    double error = 0;
    /// Mean of |u| over the mean of u along the axis: the length of the flow paths relative to a straight line.
    double tortuosity = 1;
    double porosity = 0; ///< share of the particles that are liquid, 0 to 1
    double left = 0;     ///< possible relative change of k in time: the correction by the extrapolation
    long long steps = 0; ///< time steps that it took
};

/// Settings of permeability().
struct PermeabilityRun {
    double left = 0.01;       ///< ends when the extrapolation in time adds less than this share of k; 1e-4 to 0.5
    long long steps = 100000; ///< ends with an Error if it has not converged after this many
    int threads = 0;          ///< 1 to 1024; 0: all of the machine
    /// Called at times with the share of k that is still missing, for example to print it.
    std::function<void(double)> progress{};
};

namespace porous {

/// The liquid in the pores. Units: of length the spacing, of density the liquid's, of viscosity its kinematic one.
struct Liquid : Fluid<LinearState, VolumeContinuity<QuinticSpline>, VolumePressure<QuinticSpline>,
                      MorrisViscosity<QuinticSpline>> {};
/// The body, which is rigid.
struct Grains : Wall<> {};
/// No-slip between liquid and body.
struct Contact : Coupling<Liquid, Grains, Into<Grains, PressureExtrapolation<QuinticSpline>>,
                          VolumePressure<QuinticSpline>, Into<Liquid, NoSlipContinuity<QuinticSpline>>,
                          Into<Grains, NoSlipVelocity<QuinticSpline>>, NoSlipViscosity<QuinticSpline>> {};

} // namespace porous

/// The permeability of a periodic cell filled with particles of liquid and of a rigid body, for a pressure gradient
/// along `axis`: k_i = mu u_i/f, m^2, with the mean velocity u over the whole cell (Darcy) and the driving force f per
/// volume.
///
/// The flow is slow, so that k depends on neither liquid nor force. It starts from rest; its mean approaches the steady
/// value like exp(-t/T), which is extrapolated from three times (Aitken).
///
/// Not for fast flow in wide pores (Forchheimer), nor for pores narrower than 4 spacings. k is too large, by an error
/// that falls with the square of the spacing: permeability() of a shape corrects that.
///
/// Source: creeping flow through grains by SPH with no-slip walls: Holmes, Williams and Tilke (2011).
/// @tparam Real float or double, of the run
/// @param pores places of the liquid's particles, m
/// @param body places of the body's particles, m
/// @param cell the periodic cell, m
/// @param spacing of all particles, m
/// @param axis along which the pressure falls: 0, 1, 2
/// @param run how long, and on how many threads
/// @throws Error for numbers out of range, and where the flow is not steady after PermeabilityRun::steps
template <class Real = float>
[[nodiscard]] Permeability permeability_of_particles(const std::vector<Point<3>>& pores,
                                                     const std::vector<Point<3>>& body, const Box<3>& cell,
                                                     double spacing, int axis, const PermeabilityRun& run = {}) {
    constexpr const char* who = "permeability";
    detail::require_positive(who, "spacing", spacing, "Give the distance between particles in metres.");
    require(axis >= 0 && axis < 3, who, ": axis = ", axis, " must be from 0 to 2.");
    require(cell.bounded(), who, ": the cell must be bounded. Give two corners.");
    require(!pores.empty(), who, ": there are no particles of liquid; the body fills its cell at this spacing.");
    require(!body.empty(), who, ": there are no particles of the body; nothing resists the flow.");
    require(run.left >= 1e-4 && run.left <= 0.5, who, ": PermeabilityRun::left = ", run.left,
            " must be from 1e-4 to 0.5.");
    require(run.steps >= 1, who, ": PermeabilityRun::steps = ", run.steps, " must be at least 1.");
    for (int k = 0; k < 3; ++k)
        require(cell.size()[k] >= 3.3 * spacing, who, ": the cell is ", cell.size()[k] / spacing,
                " spacings long along ", "xyz"[k], "; it must be at least 3.3.");

    // In spacings, so that bodies of micrometres keep their digits in float.
    const auto scaled = [&](const std::vector<Point<3>>& points) {
        std::vector<Point<3>> result(points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            result[i] = (points[i] - cell.lower()) / spacing;
        return result;
    };
    const Point<3> size = cell.size() / spacing;
    // The sound speed is three times the viscosity over the spacing, which makes its step not much shorter than that of
    // viscosity. The force compresses the liquid by 1e-3 from end to end, which float still resolves.
    const double sound = 3, force = 1e-3 * sound * sound / size[axis];
    // Warnings would be about a scene that the caller does not know; the error says what is wrong with k.
    Settings<3> settings{.support_radius = 3,
                         .cfl = 0.6,
                         .max_time_step = 1,
                         .search_interval = 20,
                         .threads = run.threads,
                         .on_warning = {}};
    for (int k = 0; k < 3; ++k) {
        settings.periodic_length[static_cast<std::size_t>(k)] = size[k];
        settings.gravity[static_cast<std::size_t>(k)] = k == axis ? force : 0;
    }
    Solver<3, Real, SymplecticEuler, porous::Liquid, porous::Grains, porous::Contact> scene(settings);
    const auto liquid =
        scene.add(porous::Liquid{{.density = 1, .sound_speed = sound, .viscosity = 1}}, scaled(pores), 1);
    scene.add(porous::Grains{{.density = 1}}, scaled(body), 1);

    Permeability found{};
    found.porosity = static_cast<double>(pores.size()) / static_cast<double>(pores.size() + body.size());
    const auto look = [&] { // at the mean flux over the cell, and its direction
        Point<3> sum = Point<3>::Zero();
        double speeds = 0;
        const auto v = scene[liquid][velocity];
        for (Eigen::Index i = 0; i < v.rows(); ++i) {
            const Point<3> u = v.row(i).transpose().template cast<double>();
            sum += u;
            speeds += u.norm();
        }
        found.tortuosity = sum[axis] > 0 ? speeds / sum[axis] : 0;
        return Point<3>(sum / (size.prod() * force));
    };
    std::vector<Point<3>> fluxes;
    for (double interval = 2, end = interval;; end += interval) {
        scene.run_until(end);
        fluxes.push_back(look());
        const std::size_t n = fluxes.size();
        // Three evenly spaced times: the last, the middle and the first.
        if (n % 2 == 1 && n >= 5) {
            const double a = fluxes[0][axis], b = fluxes[n / 2][axis], c = fluxes[n - 1][axis];
            const double ratio = (c - b) / (b - a); // exp(-time/T)
            const double missing = ratio < 0.95 && ratio > -0.5 ? (c - b) * ratio / (1 - ratio) : c;
            found.left = std::abs(missing / (c + missing));
            found.steps = static_cast<long long>(scene.steps());
            if (run.progress)
                run.progress(found.left);
            if (c > 0 && found.left < run.left) {
                found.column = fluxes.back() * ((c + missing) / c) * spacing * spacing;
                return found;
            }
            require(
                found.steps < run.steps, who, ": after ", found.steps, " steps the flow is not steady; ",
                100 * found.left,
                " % of it are missing. Wide pores take long: allow more PermeabilityRun::steps, or a wider spacing.");
        }
        if (n == 65) { // check it less often
            std::vector<Point<3>> every_second;
            for (std::size_t i = 1; i < n; i += 2)
                every_second.push_back(fluxes[i]);
            fluxes = every_second;
            interval *= 2;
        }
    }
}

/// The permeability of a shape in its bounds, which are taken as a periodic cell: that of permeability_of_particles(),
/// with liquid and body packed together so that both follow the surface, at the spacing and at one about 1.5 times as
/// wide. The error falls with the square of the spacing, so the two results are extrapolated to zero spacing
/// (Richardson); Permeability::error is the correction. If it is more than half of k, pores are hardly resolved, and k
/// is left as it is at the spacing.
///
/// A shape that is not periodic across the sides of its bounds is mirrored first (ImageBody: Beyond::mirrored).
/// @tparam Real float or double, of the run
/// @param shape the body: pores are what it leaves of its bounds
/// @param spacing of the particles, m; each side of the bounds must be a whole number of spacings
/// @param axis along which the pressure falls: 0, 1, 2
/// @param run how long, and on how many threads
/// @throws Error as permeability_of_particles() and fitted() do
template <class Real = float, AnyShape S>
requires(shape_dimension<S> == 3) [[nodiscard]] Permeability
    permeability(const S& shape, double spacing, int axis, const PermeabilityRun& run = {}) {
    const Box<3> cell = shape.bounds();
    detail::require_whole_spacings("permeability", cell, spacing);
    const auto at = [&](double of) {
        const auto parts = fitted_together(of, cell.lower(), 0, shape, cell - shape);
        return permeability_of_particles<Real>(parts[1], parts[0], cell, of, axis, run);
    };
    Permeability found = at(spacing);
    if (const double wide = detail::wider_spacing(cell, spacing); wide > 0) {
        const Point<3> less = (at(wide).column - found.column) / (sq(wide / spacing) - 1);
        found.error = std::abs(less[axis]);
        if (found.error < 0.5 * std::abs(found.column[axis])) // else the pores are not resolved, and nothing is gained
            found.column -= less;
    }
    return found;
}

} // namespace imbibe
