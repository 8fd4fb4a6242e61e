// Reports on a mesh and its problems in sentences, before particles are placed.
#pragma once

#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/mesh.hpp>
#include <imbibe/geometry/thickness.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace imbibe {

/// The results of mesh_report().
struct MeshReport {
    Point<3> size;                      ///< lengths of the sides of its bounding box, m
    double volume;                      ///< m^3
    double thin;                        ///< share of the volume that is thinner than three spacings, 0 to 1
    double volume_error;                ///< relative excess of the volume of the particles of fill(), without unit
    MeshDamage damage;                  ///< what was repaired, and what is left
    bool sound;                         ///< does no sentence name a problem?
    std::vector<std::string> sentences; ///< one for each finding, to print
};

/// Compares a mesh with the particle spacing (m) that will fill it: its size, damage, thin parts, and its volume on a
/// lattice. Throws Error unless the spacing is finite and > 0 m.
[[nodiscard]] inline MeshReport mesh_report(const TriangleMesh& mesh, double spacing) {
    detail::require_positive("mesh_report", "spacing", spacing, "Give the distance between particles in metres.");
    const Point<3> size = mesh.bounds().size();
    const double across = size.maxCoeff() / spacing;
    MeshReport report{size, 0, 1, -1, mesh.damage(), true, {}};
    const auto say = [&](bool see_to_it, std::string sentence) {
        report.sound = report.sound && !see_to_it;
        report.sentences.push_back(std::move(sentence));
    };
    const auto plural = [](long long n, const char* one, const char* many) {
        return text(n, " ", n == 1 ? one : many);
    };
    const std::string sides = point_text<3>(size);
    say(across < 10 || across > 3000,
        text("It is ", sides, " in size, ", across, " spacings of ", spacing, " m at its longest",
             across < 10 || across > 3000
                 ? ": was it read with the right unit (metres, millimetres, inches)? 10 to 3000 spacings are usual."
                 : "."));
    const auto triangles = static_cast<long long>(mesh.facets().size());
    const MeshDamage& damage = report.damage;
    say(false, text("It has ", plural(triangles, "triangle", "triangles"), " in ",
                    plural(damage.parts, "piece", "pieces"), " of surface."));
    if (damage.open_edges > 0)
        say(true, text("It leaks: ", plural(damage.open_edges, "edge has", "edges have"),
                       " a triangle on one side only. What is inside is guessed there; close the gaps if the shape "
                       "there matters."));
    if (damage.odd_edges > 0)
        say(true, text(plural(damage.odd_edges, "edge has", "edges have"),
                       " more than two triangles: pieces of surface meet there. Look at the shape there."));
    if (damage.inside_out > 0)
        say(false, text(plural(damage.inside_out, "piece was", "pieces were"), " inside out and turned."));
    if (damage.flipped > 0)
        say(false, text(plural(damage.flipped, "triangle faced", "triangles faced"),
                        " the other way than those beside, and was turned."));
    if (damage.copies > 0)
        say(false, text(plural(damage.copies, "triangle was", "triangles were"), " there twice, and kept once."));
    if (damage.inner > 0)
        say(false, text(plural(damage.inner, "triangle", "triangles"),
                        " between two bodies that touch were dropped; they are one body now."));
    if (damage.degenerate > 0)
        say(false, text(plural(damage.degenerate, "triangle", "triangles"), " without area were dropped."));

    if (across > 3000 || across < 0.5) { // a wrong unit would take too much memory
        say(true, "Its volume at this spacing was not looked at.");
        return report;
    }
    report.volume = mesh.volume();
    const double particles = report.volume / std::pow(spacing, 3);
    if (particles < 1) {
        say(true, text("Its volume, ", report.volume, " m^3, is less than that of one particle of ", spacing,
                       " m. Take a smaller spacing."));
        return report;
    }
    double filled = 0;
    try {
        filled = static_cast<double>(fill(mesh, spacing).size());
    } catch (const Error&) { // thinner than the lattice
    }
    report.volume_error = filled / particles - 1;
    say(std::abs(report.volume_error) > 0.01,
        text("Its volume is ", report.volume, " m^3, ", std::llround(particles), " particles; fill() would place ",
             std::llround(filled), ", ", 100 * report.volume_error, " % more, fitted() the right number."));
    report.thin = thin_share(mesh, 3 * spacing);
    say(report.thin > 0.1,
        text(100 * report.thin, " % of it is thinner than three spacings",
             report.thin > 0.1 ? text(": too coarse for what bends or holds water back there. Take a smaller spacing.")
                               : text(".")));
    return report;
}

} // namespace imbibe
