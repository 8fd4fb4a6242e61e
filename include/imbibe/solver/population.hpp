// New particles of a phase: what must be true of them, and how they are put among those that are there.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/geometry/point.hpp>
#include <imbibe/solver/neighbourhood.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace imbibe {

/// A particle that was handed over to another phase.
struct Handed {
    std::uint32_t before; ///< its number (`ids`) in the phase that it left
    std::uint32_t now;    ///< in the one that it came to
};

} // namespace imbibe

namespace imbibe::detail {

/// Throws Error if a support radius, m, is no length, or so long that a particle would see a neighbour twice through a
/// periodic side.
template <int dim, class Real>
void require_support(const Neighbourhood<dim, Real>& scene, double support, const std::string& name);

/// The same of the terms that say themselves how far they reach, if their phases have particles.
template <int dim, class Real>
void require_supports_of_terms(const Neighbourhood<dim, Real>& scene);

/// The places of new particles as they are stored: without the origin, inside the period, and that also once rounded.
/// @param origin of the points, m
/// @throws Error for a point that is not finite, too many points, a spacing that float does not bear, a point nearer
/// than 1e-3 spacings to another or to a particle of the phase, and in a total-Lagrangian phase a point within the
/// support radius of where a particle was added that has left by more than a tenth of the distance
template <int dim, class Real>
std::vector<Point<dim>> places_of_new(const Neighbourhood<dim, Real>& scene, int phase,
                                      const std::vector<Point<dim>>& points, double spacing, double support,
                                      const Origin<dim>& origin);

/// Adds particles at places that places_of_new returned, free of stress and not held, with the density of their
/// material, kg/m^3, and a mass of density * spacing^dim; all else is zero.
template <int dim, class Real>
void add_particles(PhaseStore<dim, Real>& phase, const std::vector<Point<dim>>& places, double density, double spacing);

/// Takes particles out of one phase and adds them to another, with all fields that both have by name, unit and rank;
/// what only the other one has begins as with particles that are added. The density keeps its ratio to that at rest.
/// @throws Error where the other phase has not been given its material
template <int dim, class Real>
std::vector<Handed> hand_over(PhaseStore<dim, Real>& from, PhaseStore<dim, Real>& to, const std::vector<char>& which);

} // namespace imbibe::detail

#if IMBIBE_READS_CODE
#include <imbibe/solver/population_code.hpp>
#endif
