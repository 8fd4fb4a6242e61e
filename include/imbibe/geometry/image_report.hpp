// Reports on an image of a porous body in sentences, before particles are placed.
#pragma once

#include <imbibe/geometry/distance_transform.hpp>
#include <imbibe/geometry/image.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace imbibe {

/// The results of image_report().
struct ImageReport {
    double porosity;        ///< share of pore voxels, 0 to 1
    double porosity_lower;  ///< the same with a threshold lower by 5 % of the range of grey values
    double porosity_higher; ///< and higher by as much
    int pieces;             ///< of the solid
    double islands;         ///< share of the solid that is not connected to its largest piece, 0 to 1
    std::array<bool, 3> pores_lead_through;  ///< along x, y, z
    std::array<bool, 3> solid_leads_through; ///< along x, y, z
    /// Widths of pores, m: a tenth, a half and nine tenths of the pore space is narrower (local thickness).
    std::array<double, 3> pore_widths;
    bool sound;                         ///< does no sentence name a problem?
    std::vector<std::string> sentences; ///< one for each finding, to print
};

/// Pore widths (m) below which a tenth, a half and nine tenths of the pore space lie: the width at a place is the
/// diameter of the largest ball that covers it and fits into the pores. Found by voxels, in steps of a seventh, and up
/// to a voxel too narrow if the middle of a pore lies between two.
///
/// Source: the local thickness of Hildebrand and Ruegsegger (1997).
[[nodiscard]] inline std::array<double, 3> pore_widths(const ImageBody& body) {
    const GreyImage& image = body.image();
    std::array<std::size_t, 3> cells;
    std::array<double, 3> step;
    const Point<3>& sides = body.voxels().sides;
    const double unit = sides.minCoeff();
    for (std::size_t k = 0; k < 3; ++k) {
        cells[k] = static_cast<std::size_t>(image.size[k]);
        step[k] = sides[static_cast<int>(k)] / unit;
    }
    constexpr double nowhere = 1e15;
    std::vector<double> depth(image.values.size());
    double pores = 0;
    for (std::size_t i = 0; i < depth.size(); ++i) {
        const bool solid = body.is_solid(i);
        depth[i] = solid ? 0.0 : nowhere;
        pores += solid ? 0 : 1;
    }
    std::array<double, 3> widths{};
    if (pores == 0)
        return widths;
    detail::spread_distances<3>(depth, cells, step); // from centre to centre; the face is half a voxel nearer
    double greatest = 0;
    for (double& d : depth) {
        d = d >= nowhere / 2 ? nowhere : std::max(std::sqrt(d) - 0.5, 0.0);
        greatest = std::max(greatest, d);
    }
    if (greatest >= nowhere) // no solid
        return {unit * nowhere, unit * nowhere, unit * nowhere};
    const std::array<double, 3> parts{0.1, 0.5, 0.9};
    std::vector<double> to_middle(depth.size());
    double covered_before = 0, radius_before = greatest;
    for (double radius = greatest; radius > 0.4; radius /= 8.0 / 7) {
        for (std::size_t i = 0; i < depth.size(); ++i)
            to_middle[i] = depth[i] >= radius ? 0.0 : nowhere;
        detail::spread_distances<3>(to_middle, cells, step);
        double covered = 0;
        for (std::size_t i = 0; i < depth.size(); ++i)
            covered += depth[i] > 0 && std::sqrt(to_middle[i]) <= radius ? 1 : 0;
        covered /= pores;
        for (std::size_t k = 0; k < 3; ++k)
            if (const double wider = 1 - parts[k]; widths[k] == 0 && covered >= wider) {
                const double share =
                    covered > covered_before ? (wider - covered_before) / (covered - covered_before) : 1;
                widths[k] = 2 * unit * (radius_before + share * (radius - radius_before));
            }
        covered_before = covered, radius_before = radius;
    }
    for (double& width : widths)
        width = std::max(width, unit);
    return widths;
}

/// Checks an image of a porous body that is to be filled with particles of a spacing (m): its porosity and its
/// sensitivity to the threshold, islands, whether pores and solid are connected from side to side, and the widths of
/// the pores. Throws Error unless the spacing is finite and > 0 m.
[[nodiscard]] inline ImageReport image_report(const ImageBody& body, double spacing) {
    detail::require_positive("image_report", "spacing", spacing, "Give the distance between particles in metres.");
    const GreyImage& image = body.image();
    ImageReport report{};
    report.sound = true;
    const auto say = [&](bool see_to_it, std::string sentence) {
        report.sound = report.sound && !see_to_it;
        report.sentences.push_back(std::move(sentence));
    };
    const auto [least, greatest] = std::minmax_element(image.values.begin(), image.values.end());
    const double range = static_cast<double>(*greatest) - static_cast<double>(*least);
    const double voxel = body.voxels().sides.minCoeff();
    say(spacing < voxel, text("It has ", image.size[0], " x ", image.size[1], " x ", image.size[2], " voxels, is ",
                              point_text<3>(body.image_box().size()), " in size, and has grey values from ", *least,
                              " to ", *greatest, ". A spacing of ", spacing, " m is ", spacing / voxel,
                              spacing < voxel ? " voxels: finer than what was seen." : " voxels."));

    const auto porosity_at = [&](double threshold) {
        const auto from = std::count_if(image.values.begin(), image.values.end(),
                                        [&](float v) { return static_cast<double>(v) >= threshold; });
        const double share = static_cast<double>(from) / static_cast<double>(image.values.size());
        return body.voxels().solid == SolidIs::above ? 1 - share : share;
    };
    const double threshold = body.voxels().threshold;
    report.porosity = porosity_at(threshold);
    report.porosity_lower = porosity_at(threshold - 0.05 * range);
    report.porosity_higher = porosity_at(threshold + 0.05 * range);
    const double swing = std::abs(report.porosity_higher - report.porosity_lower);
    say(swing > 0.02,
        text("Its porosity is ", report.porosity, " with the threshold ", threshold, ", ", report.porosity_lower,
             " and ", report.porosity_higher, " with one lower and higher by ", 0.05 * range,
             swing > 0.02 ? ": results will hang on the threshold. Say it with them." : "."));

    const Pieces solid = pieces_of(body), pores = pieces_of(body, false);
    report.pieces = static_cast<int>(solid.number.size());
    long long all = 0;
    for (const long long n : solid.number)
        all += n;
    if (solid.largest >= 0)
        report.islands =
            1 - static_cast<double>(solid.number[static_cast<std::size_t>(solid.largest)]) / static_cast<double>(all);
    say(report.islands > 0,
        report.pieces <= 1
            ? std::string("Its solid is one piece.")
            : text("Its solid is in ", report.pieces, " pieces; those but the largest are ", 100 * report.islands,
                   " % of it, and nothing holds them. Leave them out with without_islands(), or hold them."));
    std::string open, closed, standing;
    for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        report.pores_lead_through[k] = pores.lead_through(image, axis);
        report.solid_leads_through[k] = solid.lead_through(image, axis);
        std::string& pore = report.pores_lead_through[k] ? open : closed;
        pore += text(pore.empty() ? "" : ", ", "xyz"[axis]);
        if (!report.solid_leads_through[k])
            standing += text(standing.empty() ? "" : ", ", "xyz"[axis]);
    }
    say(!closed.empty(), closed.empty() ? std::string("Pores lead through along x, y and z.")
                         : open.empty() ? std::string("No pore leads through along any axis.")
                                        : text("Pores lead through along ", open, ", none along ", closed, "."));
    if (!standing.empty())
        say(true, text("The solid does not reach from side to side along ", standing,
                       ": no stress is carried through there."));
    if (report.porosity > 0) {
        report.pore_widths = pore_widths(body);
        const double half = report.pore_widths[1] / spacing;
        say(half < 8,
            text("A tenth, a half and nine tenths of the pore space are narrower than ", report.pore_widths[0], ", ",
                 report.pore_widths[1], " and ", report.pore_widths[2], " m; the half is ", half, " particles",
                 half < 2   ? ", closed to them."
                 : half < 8 ? ", too few for the right resistance to flow (8)."
                            : "."));
    }
    return report;
}

} // namespace imbibe
