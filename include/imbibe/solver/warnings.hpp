// Warnings about a scene before it runs: a support that is too narrow, overlapping phases, a fluid compressed by its
// own weight, a nearly incompressible solid, coordinates that float does not resolve. layout_checks.hpp checks the
// arrangement of particles.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/core/error.hpp>
#include <imbibe/core/phase.hpp>
#include <imbibe/geometry/point.hpp>
#include <imbibe/solver/closed_fluid.hpp>
#include <imbibe/solver/layout_checks.hpp>
#include <imbibe/solver/neighbourhood.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace imbibe::detail {

/// Sentences, each once.
class Warnings {
public:
    /// @param tell is called with each new one; may be empty
    explicit Warnings(std::function<void(const std::string&)> tell) : tell_(std::move(tell)) {}
    /// Adds a sentence; an empty one is ignored.
    void note(const std::string& sentence) {
        if (sentence.empty() || std::find(sentences_.begin(), sentences_.end(), sentence) != sentences_.end())
            return;
        sentences_.push_back(sentence);
        if (tell_)
            tell_(sentence);
    }
    const std::vector<std::string>& sentences() const { return sentences_; }

private:
    std::function<void(const std::string&)> tell_;
    std::vector<std::string> sentences_;
};

/// A sentence if a particle of a square or cubic lattice has too few neighbours, or so many that units are probably
/// mixed up; else empty.
/// @param ratio the support radius in spacings
std::string warning_of_support(double ratio, int dim, const std::string& name);

/// A sentence if particles of two phases that see each other start nearer than 0.3 of their mean spacing; else empty.
/// No error, even if they coincide: phases that drag or heat each other may overlap.
/// @param link the phases' link, @param scene after a search, @param origin of its coordinates, m
template <int dim, class Real>
std::string warning_of_overlap(const Link& link, const Neighbourhood<dim, Real>& scene, const Origin<dim>& origin);

/// A sentence if particles of a phase are further apart than the spacing that they were added with, which gives their
/// mass; else empty. The nearest one is a spacing away on square and cubic lattices, 1.12 on a face-centred one, and
/// 0.6 where particles of a lattice are moved at random by up to 0.3 spacings. (Nearer ones are crowded.)
/// @param link of the phase to itself
template <int dim, class Real>
std::string warning_of_other_spacing(const Link& link, const Neighbourhood<dim, Real>& scene);

/// A sentence if a coupling pushes a fluid by pressure, and the fluid's density, which follows from its motion, does
/// not count the other phase; else empty. The pressure then does not rise as the fluid comes nearer, and the fluid goes
/// through, unless there is a repulsion, which rises by itself.
std::string warning_of_no_continuity(const std::string& coupling, const std::string& fluid, const std::string& other);

/// The greatest difference of the potential of gravity (m/s^2), m^2/s^2, between particles of one body of a fluid;
/// particles up to 1.5 spacings apart belong to one body. Periodic directions do not count.
double greatest_head(const Outline& fluid, const Coordinates& gravity, const OutlineOfScene& scene);

/// A sentence if a fluid is compressed by a twentieth under its own weight; else empty. Bodies of it that do not touch
/// do not press on each other.
/// @param scene after a search, @param outline its own
template <int dim, class Real>
std::string warning_of_soft_fluid(const Neighbourhood<dim, Real>& scene, int phase, const OutlineOfScene& outline);

/// A sentence if a scene in float lies so far from its origin that forces lose digits; else empty. If the scene itself
/// is as wide as that, another origin does not help.
/// @param scene after a search, @param origin of its coordinates, m
template <int dim, class Real>
std::string warning_of_far_origin(const Neighbourhood<dim, Real>& scene, const Origin<dim>& origin);

/// A sentence if two fluids that meet have different support radii; else empty.
template <int dim, class Real>
std::string warning_of_other_support(const PhaseStore<dim, Real>& a, const PhaseStore<dim, Real>& b);

/// A sentence if a phase is less compressible than a law of its stress allows; else empty.
template <class Term, class P>
std::string warning_of_poisson_ratio(const P& material, const std::string& name) {
    if constexpr (requires { Term::greatest_poisson_ratio, material.poisson_ratio(); })
        if (const double nu = material.poisson_ratio();
            nu > Term::greatest_poisson_ratio && material.warning(name).empty()) // else that one says more
            return text(name, ": Poisson's ratio ", nu, " with ", type_name<Term>(), ", whose mean stress alternates ",
                        "from particle to particle above ", Term::greatest_poisson_ratio,
                        "; take VolumetricDeviatoric with a total-Lagrangian solid, or a smaller ratio");
    return {};
}

/// Notes doubts about the material of a phase, as soon as it has particles.
template <int dim, class P, class... Term>
void note_doubts_of_material(Warnings& warnings, const P& material, const std::string& name, TypeList<Term...>) {
    warnings.note(warning_of_support(material.support_radius / material.spacing, dim, name));
    (warnings.note(warning_of_poisson_ratio<Term>(material, name)), ...);
    if constexpr (requires { material.warning(name); })
        warnings.note(material.warning(name));
}

/// Notes doubts about the arrangement of a scene's particles, and about its couplings.
/// @param scene after a search, @param origin of its coordinates, m, @param outline its own
template <int dim, class Real>
void note_doubts_of_scene(Warnings& warnings, const Neighbourhood<dim, Real>& scene, const Origin<dim>& origin,
                          const OutlineOfScene& outline);

} // namespace imbibe::detail

#if IMBIBE_READS_CODE
#include <imbibe/solver/warnings_code.hpp>
#endif
