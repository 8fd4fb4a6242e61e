// Reports in a sentence whether water can pass the pores of a sponge at a given particle spacing.
#pragma once

#include <imbibe/geometry/shape.hpp>

#include <concepts>
#include <string>

namespace imbibe {

/// A shape with pores: `porosity()`, the open part of its box (0 to 1), and `pore_width()`, the diameter (m) of the
/// largest ball that passes through it.
template <class S>
concept PorousShape = AnyShape<S> && requires(const S& sponge) {
    { sponge.porosity() } -> std::convertible_to<double>;
    { sponge.pore_width() } -> std::convertible_to<double>;
};

/// How well particles resolve a pore.
enum class PoreGrade {
    closed, ///< narrower than two particles: at most single particles pass, whatever the physics
    narrow, ///< two to eight particles: open, but the resistance to flow is off by more than about 15 %
    open    ///< eight particles or more
};

/// The results of pore_report().
struct PoreReport {
    double width;         ///< largest ball that passes, m
    double particles;     ///< the same in particle spacings
    double porosity;      ///< open part of the box, 0 to 1
    PoreGrade grade;      ///< the verdict
    std::string sentence; ///< the results in words, to print
};

/// Compares the pores of a sponge with the particle spacing (m) of the finest phase that must pass them. Throws Error
/// unless the spacing is finite and > 0 m.
template <PorousShape S>
[[nodiscard]] PoreReport pore_report(const S& sponge, double spacing) {
    detail::require_positive("pore_report", "spacing", spacing, "Give the distance between particles in metres.");
    PoreReport report{sponge.pore_width(), 0, sponge.porosity(), PoreGrade::open, {}};
    report.particles = report.width / spacing;
    // One part in 1e9 of slack: a pore of exactly two particles should not be closed by round-off.
    if (report.particles < 2 * (1 - 1e-9))
        report.grade = PoreGrade::closed;
    else if (report.particles < 8 * (1 - 1e-9))
        report.grade = PoreGrade::narrow;

    report.sentence = text("porosity ", report.porosity, ", pores ", report.width, " m wide = ", report.particles,
                           " particles of ", spacing, " m: ");
    if (report.width <= 0)
        report.sentence += "no passage leads through.";
    else if (report.grade == PoreGrade::closed)
        report.sentence += text("numerically closed (fewer than 2 particles). Water needs a spacing of at most ",
                                report.width / 2, " m to enter, ", report.width / 4, " m to pass with ease.");
    else if (report.grade == PoreGrade::narrow)
        report.sentence += text("open but narrow (fewer than 8 particles): expect too much resistance to flow, and "
                                "below 4 particles little passage at all. A spacing of ",
                                report.width / 8, " m resolves them.");
    else
        report.sentence += "open and resolved.";
    return report;
}

} // namespace imbibe
