// The total-Lagrangian solid of the cases, and what its plates have alike.
#pragma once

#include "../support/elastic.hpp"
#include "case.hpp"

#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/monitor/energy.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/time/symplectic_euler.hpp>

namespace validation {

namespace sph = imbibe;

/// No viscosity: what is lost, the scheme has lost.
struct ElasticPlate : sph::Solid<sph::ReferenceCorrection<>, sph::DeformationGradient<>, sph::StVenantKirchhoff,
                                 sph::TotalLagrangianForce<>, sph::HourglassControl<>, sph::Clamped> {};
using PlateScene = sph::Solver<2, double, sph::SymplecticEuler, ElasticPlate>;

using sph::bench::elastic;

/// The displacement, m, of the middle of the far end of a plate along x that has `across` particles over its thickness:
/// the end is half a spacing beyond the last column of particles.
template <class View>
sph::Point<2> end_displacement(const View& view, int across) {
    const auto X = view[sph::reference_position], x = view[sph::position];
    const double spacing = view.material().spacing, last = X.col(0).maxCoeff();
    sph::Point<2> sum = sph::Point<2>::Zero();
    for (int i = 0; i < view.size(); ++i) {
        const double weight = X(i, 0) > last - 0.5 * spacing ? 1.5 : X(i, 0) > last - 1.5 * spacing ? -0.5 : 0;
        if (weight != 0)
            sum += weight / across * (x.row(i) - X.row(i)).transpose();
    }
    return sum;
}

} // namespace validation
