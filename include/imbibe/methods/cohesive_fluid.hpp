// The terms of a liquid with surface tension and no gas around it.
#pragma once

#include <imbibe/core/method.hpp>
#include <imbibe/interface/cohesion.hpp>

namespace imbibe {

/// A liquid with a free surface that has a tension: `Fluid<CohesiveFluid, MorrisViscosity<WendlandC6>>`, with
/// CohesionParameters and a support radius of 5 spacings. It brings its equation of state, CohesivePressure.
///
/// Its couplings with walls and solids, which its pressure pushes and its adhesion pulls, have AdhesionParameters.
struct CohesiveFluid : Method<CohesivePressure, SummationDensity<WendlandC6>, SymmetricPressure<WendlandC6>, Cohesion> {
    /// What acts between such a fluid and a wall or solid.
    template <class Liquid, class Other>
    using coupling = TypeList<CohesiveContact, Into<Liquid, SummationNeighbours<WendlandC6>>, Adhesion>;
};

} // namespace imbibe
