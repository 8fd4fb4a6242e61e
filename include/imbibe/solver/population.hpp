// New particles of a phase: the checks they must pass, and how they join the existing ones.
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
    std::uint32_t now;    ///< its number in the phase that it joined
};

} // namespace imbibe

namespace imbibe::detail {

/// Throws Error if a support radius, m, is no length, or so long that a particle would see a neighbour twice through a
/// periodic side.
template <int dim, class Real>
void require_support(const Neighbourhood<dim, Real>& scene, double support, const std::string& name);

/// The same for terms with a support radius of their own, if their phases have particles.
template <int dim, class Real>
void require_supports_of_terms(const Neighbourhood<dim, Real>& scene);

/// The positions of new particles as stored: relative to the origin, inside the period, also after rounding.
/// @param origin of the points, m
/// @throws Error for a point that is not finite, too many points, a spacing that float does not bear, a point nearer
/// than 1e-3 spacings to another or to a particle of the phase, and in a total-Lagrangian phase a point within the
/// support radius of where a particle was added that has left by more than a tenth of the distance
template <int dim, class Real>
std::vector<Point<dim>> places_of_new(const Neighbourhood<dim, Real>& scene, int phase,
                                      const std::vector<Point<dim>>& points, double spacing, double support,
                                      const Origin<dim>& origin);

/// Adds particles at places that places_of_new returned, stress-free and not held, with the density of their material,
/// kg/m^3, and a mass of density * spacing^dim; all other fields are zero.
template <int dim, class Real>
void add_particles(PhaseStore<dim, Real>& phase, const std::vector<Point<dim>>& places, double density, double spacing);

/// Moves particles from one phase to another, with all fields that both have by name, unit and rank; fields that only
/// the other one has start as for added particles. The ratio of the density to the reference density is kept.
/// @throws Error where the other phase has not been given its material
template <int dim, class Real>
std::vector<Handed> hand_over(PhaseStore<dim, Real>& from, PhaseStore<dim, Real>& to, const std::vector<char>& which);

} // namespace imbibe::detail

#if IMBIBE_READS_CODE
#include <imbibe/solver/population_code.hpp>
#endif
