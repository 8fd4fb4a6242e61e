// The code of warnings.hpp: checks a scene and makes the sentences.
#pragma once

#include <imbibe/solver/warnings.hpp>

namespace imbibe::detail {

IMBIBE_CODE std::string warning_of_support(double ratio, int dim, const std::string& name) {
    if (ratio >= 1.3 && ratio <= 8)
        return {};
    const auto say = [&](double neighbours, const char* consequence) {
        return text(name, ": the support radius is ", ratio, " spacings, so a particle has ", neighbours,
                    " neighbours, ", consequence, "; 2 to 3 spacings are usual");
    };
    if (ratio > 8)
        return say(std::round(dim == 2 ? 3.14 * sq(ratio) : 4.19 * sq(ratio) * ratio),
                   "which takes long and smooths everything. Are both in metres?");
    int neighbours = -1; // the particle itself is not one
    const int reach = static_cast<int>(ratio) + 1;
    for (int x = -reach; x <= reach; ++x)
        for (int y = -reach; y <= reach; ++y)
            for (int z = dim == 3 ? -reach : 0; z <= (dim == 3 ? reach : 0); ++z)
                neighbours += x * x + y * y + z * z < ratio * ratio * (1 - 1e-9);
    return say(neighbours, "too few: gradients come out too small");
}

template <int dim, class Real>
std::string warning_of_overlap(const Link& link, const Neighbourhood<dim, Real>& scene, const Origin<dim>& origin) {
    const auto &a = scene.phase(link.row.a), &b = scene.phase(link.row.b);
    const auto pairs = scene.pairs_of(link);
    const double spacing = 0.5 * (a.numbers().spacing + b.numbers().spacing);
    if (!(pairs.nearest(scene.threads) < 0.3 * spacing))
        return {};
    int i = 0; // of the nearest pair
    double least = pairs.nearest_of(0).second;
    for (int k = 1; k < a.size(); ++k)
        if (const double distance = pairs.nearest_of(k).second; distance < least) {
            i = k;
            least = distance;
        }
    Point<dim> place;
    for (int d = 0; d < dim; ++d) {
        const auto axis = static_cast<std::size_t>(d);
        place[d] = static_cast<double>(a.points().x[axis][i]) + origin[axis];
    }
    return text(a.name, " and ", b.name, " overlap at the start: one pair is ", least, " m apart, ", least / spacing,
                " of their mean spacing, at ", point_text<dim>(place),
                ". What pushes them apart may throw them; half a ",
                "spacing from face to face is usual. `fill(a - b, spacing)` and `remove_if` leave out what is in the ",
                "other's way");
}

template <int dim, class Real>
std::string warning_of_other_spacing(const Link& link, const Neighbourhood<dim, Real>& scene) {
    const auto& s = scene.phase(link.row.a);
    const double spacing = s.numbers().spacing, apart = scene.pairs_of(link).median_nearest();
    if (apart == 0 || apart < 1.4 * spacing) // 0: no particle has another within reach
        return {};
    return text(s.name, ": its particles were added with a spacing of ", spacing, " m, and the next one is ", apart,
                " m away (the median). Each has the mass density * spacing^dim, so the spacing must be that of ",
                "the points");
}

IMBIBE_CODE std::string warning_of_no_continuity(const std::string& coupling, const std::string& fluid,
                                                 const std::string& other) {
    return text(coupling, " pushes ", fluid, " by pressure, but the density of ", fluid, " does not count ", other,
                ", so that the pressure does not rise where the two come nearer. List the ", fluid,
                "'s continuity equation in ", coupling, " too, as in Into<", fluid, ", VolumeContinuity<K>>");
}

IMBIBE_CODE double greatest_head(const Outline& fluid, const Coordinates& gravity, const OutlineOfScene& scene) {
    const std::vector<int> body = bodies_of(fluid.now, 1.5 * fluid.spacing, scene);
    std::vector<OutlineBox> boxes;
    for (std::size_t i = 0; i < body.size(); ++i) {
        boxes.resize(std::max(boxes.size(), static_cast<std::size_t>(body[i]) + 1));
        boxes[static_cast<std::size_t>(body[i])].include(fluid.now.at(static_cast<int>(i)));
    }
    double most = 0;
    for (const OutlineBox& box : boxes) {
        double head = 0;
        for (std::size_t d = 0; d < 3; ++d)
            if (scene.period[d] == 0)
                head += std::abs(gravity[d]) * (box.upper[d] - box.lower[d]);
        most = std::max(most, head);
    }
    return most;
}

template <int dim, class Real>
std::string warning_of_soft_fluid(const Neighbourhood<dim, Real>& scene, int phase, const OutlineOfScene& outline) {
    const auto& s = scene.phase(phase);
    if (!s.row->fluid || s.size() == 0)
        return {};
    Coordinates gravity{};
    double potential = 0; // of the highest particle over the lowest, m^2/s^2
    for (std::size_t d = 0; d < static_cast<std::size_t>(dim); ++d) {
        gravity[d] = scene.gravity[static_cast<int>(d)];
        if (scene.periodic.length[d] == 0)
            potential += std::abs(gravity[d]) * (s.bounds.upper[d] - s.bounds.lower[d]);
    }
    const double sound_speed = s.numbers().sound_speed, stiffness = sq(sound_speed);
    if (potential > 0.05 * stiffness)
        potential = greatest_head(outline[phase], gravity, outline);
    if (!(potential > 0.05 * stiffness))
        return {};
    return text(s.name, ": with a sound speed of ", sound_speed, " m/s its weight alone compresses it by ",
                100 * potential / stiffness, " % at the bottom; ", std::sqrt(200 * potential),
                " m/s, ten times the speed of a fall from top to bottom, is usual");
}

template <int dim, class Real>
std::string warning_of_far_origin(const Neighbourhood<dim, Real>& scene, const Origin<dim>& origin) {
    if (!std::is_same_v<Real, float>)
        return {};
    Point<dim> lower = Point<dim>::Constant(std::numeric_limits<double>::infinity()), upper = -lower, centre;
    double spacing = std::numeric_limits<double>::infinity();
    for (const auto& s : scene.phases) {
        if (s.size() == 0)
            continue;
        spacing = std::min(spacing, s.numbers().spacing);
        for (int d = 0; d < dim; ++d) {
            lower[d] = std::min(lower[d], static_cast<double>(s.bounds.lower[static_cast<std::size_t>(d)]));
            upper[d] = std::max(upper[d], static_cast<double>(s.bounds.upper[static_cast<std::size_t>(d)]));
        }
    }
    if (!std::isfinite(spacing))
        return {};
    const double away = std::max(lower.cwiseAbs().maxCoeff(), upper.cwiseAbs().maxCoeff());
    if (away < 1e4 * spacing || away < 2 * (upper - lower).maxCoeff())
        return {};
    for (int d = 0; d < dim; ++d)
        centre[d] = 0.5 * (lower[d] + upper[d]) + origin[static_cast<std::size_t>(d)];
    return text("coordinates reach ", away, " m from the origin, ", away / spacing, " spacings, and float has seven ",
                "digits: forces are wrong by about ", 2e-5 * away / spacing, " %. Take an origin among the particles, ",
                "such as Settings::origin = ", point_text<dim>(centre), ", or double");
}

template <int dim, class Real>
std::string warning_of_other_support(const PhaseStore<dim, Real>& a, const PhaseStore<dim, Real>& b) {
    const double of_a = a.numbers().support_radius, of_b = b.numbers().support_radius;
    if (!a.row->fluid || !b.row->fluid || a.size() == 0 || b.size() == 0 ||
        std::abs(of_a - of_b) <= 1e-9 * (of_a + of_b))
        return {};
    return text(a.name, " and ", b.name, " have support radii of ", of_a, " and ", of_b,
                " m; sums over each other reach the greater one, so that pushes from both sides do not cancel ",
                "in the other fluid; give both the same");
}

template <int dim, class Real>
void note_doubts_of_scene(Warnings& warnings, const Neighbourhood<dim, Real>& scene, const Origin<dim>& origin,
                          const OutlineOfScene& outline) {
    const auto& couplings = scene.table.couplings;
    for (std::size_t k = 0; k < couplings.size(); ++k) {
        const CouplingRow& row = couplings[k];
        const Link* const link = scene.link_of_coupling(static_cast<int>(k));
        if (link == nullptr || row.overlaps)
            continue;
        warnings.note(warning_of_overlap(*link, scene, origin));
        const Outline &a = outline[row.first], &b = outline[row.second];
        const double reach = scene.longest_support(row.first, row.second);
        if (a.size() == 0 || b.size() == 0)
            continue;
        warnings.note(warning_of_wide_spacing(a, b, reach));
        warnings.note(warning_of_other_lattice(a, b, scene.pairs_of(*link).nearest(scene.threads), outline.dim));
        const bool flows_a = a.kind == Kind::fluid, flows_b = b.kind == Kind::fluid;
        if (flows_a != flows_b && !row.asks_for_nearest) // a repulsion holds by itself
            warnings.note(warning_of_thin_wall(flows_a ? b : a, flows_a ? a : b, reach, outline));
        if ((flows_a && b.kind == Kind::wall) || (flows_b && a.kind == Kind::wall))
            warnings.note(warning_of_steps(flows_a ? b : a, flows_a ? &a : &b, outline));
    }
    for (std::size_t k = 0; k < scene.phases.size(); ++k) {
        const int phase = static_cast<int>(k);
        const Outline& a = outline[phase];
        if (a.size() == 0 && scene.phases[k].numbers().spacing == 0) // none were added, not even an empty list
            warnings.note(text(a.name, " has no particles; was scene.add forgotten?"));
        warnings.note(warning_of_soft_fluid(scene, phase, outline));
        warnings.note(warning_of_no_shifting(scene, phase));
        if (a.kind == Kind::solid) {
            warnings.note(warning_of_one_layer(a, outline));
            warnings.note(warning_of_steps(a, nullptr, outline));
        }
    }
    for (const Link& link : scene.links)
        if (link.row.a == link.row.b)
            warnings.note(warning_of_other_spacing(link, scene));
    warnings.note(warning_of_far_origin(scene, origin));
    for (const CouplingRow& row : couplings)
        warnings.note(warning_of_other_support(scene.phase(row.first), scene.phase(row.second)));
    const auto look_at_density = [&](const CouplingRow& row, int fluid, int other, bool uncounted) {
        if (uncounted && !scene.are_apart(fluid, other))
            warnings.note(warning_of_no_continuity(row.name(), scene.phase(fluid).name, scene.phase(other).name));
    };
    for (const CouplingRow& row : couplings)
        look_at_density(row, row.first, row.second, row.first_counts_no_second);
    for (const CouplingRow& row : couplings)
        look_at_density(row, row.second, row.first, row.second_counts_no_first);
}

} // namespace imbibe::detail
