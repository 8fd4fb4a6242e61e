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

/// Follows the middle of the far end of a plate along x that has `across` particles over its thickness: the end is half
/// a spacing beyond the last column of particles.
class EndProbe {
public:
    EndProbe() = default;
    /// The plate as it is before it moves.
    template <class View>
    EndProbe(const View& view, int across) : start(static_cast<std::size_t>(view.size())), weight(start.size()) {
        const auto x = view[sph::position];
        const double spacing = view.material().spacing, last = x.col(0).maxCoeff();
        for (int i = 0; i < view.size(); ++i) {
            const auto id = static_cast<std::size_t>(view.ids()[static_cast<std::size_t>(i)]);
            start[id] = x.row(i).transpose();
            weight[id] = (x(i, 0) > last - 0.5 * spacing ? 1.5 : x(i, 0) > last - 1.5 * spacing ? -0.5 : 0) / across;
        }
    }
    /// How far it has moved, m.
    template <class View>
    sph::Point<2> displacement(const View& view) const {
        const auto x = view[sph::position];
        sph::Point<2> sum = sph::Point<2>::Zero();
        for (int i = 0; i < view.size(); ++i)
            if (const auto id = static_cast<std::size_t>(view.ids()[static_cast<std::size_t>(i)]); weight[id] != 0)
                sum += weight[id] * (x.row(i).transpose() - start[id]);
        return sum;
    }

private:
    std::vector<sph::Point<2>> start; // by the particles' numbers
    std::vector<double> weight;
};

} // namespace validation
