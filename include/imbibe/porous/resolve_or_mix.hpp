// Decides whether particles should resolve the pores of a body or a mixture should represent them, with the error of
// each.
#pragma once

#include <imbibe/core/pack_functions.hpp>
#include <imbibe/geometry/point.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace imbibe {

/// A porous body and its particles: the input of resolve_or_mix().
struct PorousBody {
    double thickness = 0;    ///< the smallest size of the body, m
    double porosity = 0;     ///< the pores' share of its volume, 0 to 1
    double pore_width = 0;   ///< the largest ball that passes, m (pore_width() of shapes); 0: from the permeability
    double permeability = 0; ///< m^2; 0: from the width of the pores
    double spacing = 0;      ///< of the particles, m
};

/// The results of resolve_or_mix(). Errors are relative, without sign; 1 is 100 %.
struct PoreChoice {
    bool mix;               ///< take the mixture?
    double pore_width;      ///< as given, or from the permeability, m
    double permeability;    ///< as given, or from the width of the pores, m^2
    double across_pore;     ///< particles across a pore
    double over_body;       ///< particles over the thickness
    double resolved_flow;   ///< error of the permeability if particles resolve the pores
    double mixed_flow;      ///< error of the time in which liquid drains from a mixture
    double sag;             ///< error of the sag under the weight of the body, either way
    double resolving;       ///< the spacing with which particles resolve the pores well, m: eight across
    double times_particles; ///< how many times as many particles a body in space then has as at `spacing`
    std::string sentence;   ///< the results in words, to print
};

/// Resolve the pores of a body, or use a mixture? Resolved pores need particles across each pore; a mixture
/// (PorousSkeleton, SeepingFluid) needs them over the thickness of the body and takes the permeability as a number.
/// With N particles across a pore of the width w, and M over the thickness T:
///
/// | | resolved | mixed |
/// |---|---|---|
/// | permeability, drainage | 9/N^2, a third of it between flat walls | 13/M^2 + w/(2 T) |
/// | sag | 2.6/M | 2.6/M |
///
/// The numbers come from the cases resolved-sponge and mixed-sponge, one sponge in both ways, and for round pores from
/// LinearNoSlipVelocity's comparison; w/(2 T) is the cost of flow in and out of the ends of pores, which the mixture
/// does not have. Widths and permeabilities that are not given follow from each other as for straight round pores, k =
/// n w^2/32. The answer is the way with the smaller error of the flow, but always the mixture below four particles
/// across a pore, where particles hardly pass.
///
/// Not for processes within single pores (drops, jets, bubbles): always resolve those.
///
/// Source: round pores: Hagen and Poiseuille; errors: measured, docs/validation_table.md.
/// @throws Error for a number out of range, and where neither pore_width nor permeability is given
[[nodiscard]] inline PoreChoice resolve_or_mix(const PorousBody& body) {
    constexpr const char* who = "resolve_or_mix";
    detail::require_positive(who, "spacing", body.spacing, "Give the distance between particles in metres.");
    detail::require_positive(who, "thickness", body.thickness, "Give the smallest size of the body in metres.");
    require(body.porosity > 0 && body.porosity < 1, who, ": porosity = ", body.porosity,
            "; it must be above 0 and below 1, the share of the volume that is open.");
    for (const auto& [value, name] : {std::pair{body.pore_width, "pore_width"}, {body.permeability, "permeability"}})
        require(value >= 0 && std::isfinite(value), who, ": ", name, " = ", value,
                "; it must be finite and at least 0 (0: not known).");
    require(body.pore_width > 0 || body.permeability > 0, who,
            ": neither pore_width nor permeability is given. Give at least one; permeability(shape, spacing, axis) "
            "computes the second for a piece of the body.");
    require(body.pore_width < body.thickness, who, ": pore_width = ", body.pore_width,
            " m; it must be below the thickness of the body, ", body.thickness, " m.");

    PoreChoice found{};
    found.pore_width = body.pore_width > 0 ? body.pore_width : std::sqrt(32 * body.permeability / body.porosity);
    found.permeability =
        body.permeability > 0 ? body.permeability : body.porosity * body.pore_width * body.pore_width / 32;
    found.across_pore = found.pore_width / body.spacing;
    found.over_body = body.thickness / body.spacing;
    found.resolved_flow = std::min(1.0, 9 / sq(found.across_pore));
    found.mixed_flow = std::min(1.0, 13 / sq(found.over_body) + found.pore_width / (2 * body.thickness));
    found.sag = std::min(1.0, 2.6 / found.over_body);
    // One part in 1e9 of slack, so that exactly four particles count as four.
    found.mix = found.across_pore < 4 * (1 - 1e-9) || found.mixed_flow < found.resolved_flow;
    found.resolving = found.pore_width / 8;
    found.times_particles = std::pow(body.spacing / found.resolving, 3);

    const auto percent = [](double share) { return text(std::ceil(100 * share), " %"); };
    found.sentence = text(found.mix ? "Mix" : "Resolve", ": pores ", found.pore_width, " m wide = ", found.across_pore,
                          " particles, body ", body.thickness, " m thick = ", found.over_body,
                          " particles. Error of the flow about ", percent(found.resolved_flow), " resolved, ",
                          percent(found.mixed_flow), " mixed with a permeability of ", found.permeability,
                          " m^2; of the sag ", percent(found.sag), " either way.");
    if (found.mix && found.over_body < 10)
        found.sentence +=
            text(" The body is thinner than ten particles: take a spacing of at most ", body.thickness / 10, " m.");
    if (found.mix && found.times_particles > 1)
        found.sentence += text(" To resolve the pores takes a spacing of ", found.resolving, " m, ",
                               found.times_particles, " times as many particles.");
    if (found.mix && body.permeability == 0)
        found.sentence += " The permeability is that of straight round pores: measure it, or compute it for a piece "
                          "that particles resolve.";
    return found;
}

} // namespace imbibe
