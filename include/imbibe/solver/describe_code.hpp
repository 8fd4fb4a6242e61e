// The code of describe.hpp: puts a scene into words.
#pragma once

#include <imbibe/solver/describe.hpp>
#include <imbibe/solver/scene_watch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace imbibe::detail {

/// The name of the type in a signature.
IMBIBE_CODE std::string full_type_name(std::string_view function) {
    const auto begin = function.find("T = ") + 4;
    std::string all(function.substr(begin, function.find_last_of("];") - begin));
    all = all.substr(0, all.find("; std::string_view"));
    for (const char* noise :
         {"(anonymous namespace)::", "{anonymous}::", "imbibe::presets::", "imbibe::", ", {{}}", "{}", "()"})
        for (auto at = all.find(noise); at != std::string::npos; at = all.find(noise))
            all.erase(at, std::string_view(noise).size());
    // g++ prints default arguments of terms that a program lists by a method, and leaves them out where it lists the
    // terms themselves.
    for (const std::string_view by_default : {", Velocity", ", Tension::pulls"})
        for (auto at = all.find(by_default); at != std::string::npos; at = all.find(by_default, at + 1))
            if (const auto behind = at + by_default.size(); behind < all.size() && all[behind] == '>')
                all.erase(at, by_default.size());
    return all;
}
IMBIBE_CODE std::string type_names(std::initializer_list<std::string_view> signatures) {
    std::string names;
    for (const auto& one : signatures)
        names += (names.empty() ? "" : ", ") + full_type_name(one);
    return names.empty() ? "none" : names;
}
IMBIBE_CODE std::string limits_in_words(const std::vector<TimeStepLimit>& limits) {
    std::string words;
    for (const TimeStepLimit& limit : limits)
        words += text(" ", limit.seconds, " s (", limit.reason, ", ", limit.where, ");");
    return words;
}
/// A line that says how the lattice of a fluid under pressure resists slow shear, or none.
template <int dim, class Real>
std::string stiffness_in_words(const PhaseStore<dim, Real>& s, const TypesInWords::PhaseInWords& words) {
    if (words.shear_stiffness == 0 || words.viscosity == 0) // no fluid
        return {};
    const PhaseNumbers numbers = s.numbers();
    double pressure = 0; // from the density, as it is before the first step too
    for (int i = 0; i < s.size(); ++i)
        pressure = std::max(pressure, sq(numbers.sound_speed) * std::abs(s.own_density(i) - numbers.density));
    const double modulus = std::abs(words.shear_stiffness) * pressure; // Pa
    if (modulus == 0)
        return {};
    return text("    lattice: under its greatest pressure, some ", pressure, " Pa, it ",
                words.shear_stiffness > 0 ? "resists" : "gives way to", " slow shear with up to ", modulus,
                " Pa, as much as its viscosity at ", modulus / words.viscosity,
                " 1/s; where that counts, take the method CorrectedGradients\n");
}
/// A line that names the pairs of phases between which nothing acts, or none.
template <int dim, class Real>
std::string uncoupled_in_words(const SceneStore<dim, Real>& scene) {
    std::string words;
    for (const PhasePair& pair : pairs_of_phases(scene))
        if (!pair.coupled)
            words += text(words.empty() ? "Nothing acts between: " : "; ", scene.phase(pair.first).name, " and ",
                          scene.phase(pair.second).name);
    return words.empty() ? words : words + "\n";
}

/// Lines that say what would make the scene faster, as it is now: searches that serve several steps, a solid that takes
/// its short steps alone, terms that are evaluated in long steps; or none.
template <int dim, class Real>
std::string advice_in_words(const Neighbourhood<dim, Real>& scene, const Settings<dim>& settings,
                            const TypesInWords& types, const LimitsInWords& limits) {
    std::string words;
    const double step = limits.first.seconds;
    const bool searches =
        std::any_of(scene.links.begin(), scene.links.end(), [](const Link& link) { return !link.row.reference; });
    if (searches && settings.search_interval == 1 && limits.substep.empty()) { // DualStepping searches in long steps
        double served = 1e6; // steps in which nothing moves 5 % of its support
        for (std::size_t k = 0; k < scene.phases.size(); ++k) {
            const Motion motion = scene.motion_now(static_cast<int>(k));
            const double way = 0.05 * scene.phases[k].numbers().support_radius, v = motion.speed,
                         a = motion.acceleration;
            // v t + a t^2/2 = way
            if (scene.phases[k].row->moves && (v > 0 || a > 0))
                served = std::min(served, 2 * way / (v + std::sqrt(v * v + 2 * a * way)) / step);
        }
        if (served >= 3)
            words +=
                text("  faster: search_interval = 100 and search_skin = 0.1; as it moves now, neighbours would serve ",
                     served >= 100 ? "100" : text(std::floor(served)), " steps\n");
    }
    // What a step costs, in numbers that are loaded: the pairs inside the phase that sets the step, and all others; the
    // long and the short steps of DualStepping.
    double own = 0, others = 0, dual = 0, dual_short = 0, next = std::numeric_limits<double>::infinity();
    bool is_solid = false;
    for (std::size_t k = 0; k < scene.links.size(); ++k) {
        const LinkRow& row = scene.links[k].row;
        const double pairs = scene.phase(row.a).size() * std::max(scene.mean_neighbours(scene.links[k]), 0.0),
                     cost = pairs * types.loads[k];
        if (!types.dual.integrator.empty())
            dual += pairs * types.dual.loads[k], dual_short += pairs * types.dual.loads_in_short[k];
        const bool inside = row.a == row.b && scene.phase(row.a).name == limits.first.where;
        (inside ? own : others) += cost;
        // Subcycled takes no implicit drag.
        is_solid = is_solid || (inside && row.reference && scene.phase(row.a).row->implicit_acceleration < 0);
    }
    for (const TimeStepLimit& limit : limits.step)
        if (limit.where != limits.first.where)
            next = std::min(next, settings.cfl * limit.seconds);
    const double ratio = std::ceil(std::min(next, settings.max_time_step) / step);
    if (const double faster = (own + others) / (own + others / ratio);
        is_solid && limits.substep.empty() && faster > 1.2)
        words += text("  faster: the integrator Subcycled<", limits.first.where, ">, in which it alone takes ", ratio,
                      " short steps in each: some ", std::round(10 * faster) / 10, " times\n");
    if (const double shorter = std::ceil(std::min(settings.cfl * types.dual.step, settings.max_time_step) / step);
        shorter > 1)
        if (const double faster = shorter * (own + others) / (shorter * dual_short + dual); faster > 1.2)
            words += text("  faster: the integrator ", types.dual.integrator, ", which evaluates these terms once in ",
                          shorter, " steps: some ", std::round(10 * faster) / 10,
                          " times; not for a splash, which changes within them\n");
    return words;
}

template <int dim, class Real>
std::string describe_scene(const Neighbourhood<dim, Real>& scene, const Settings<dim>& settings,
                           const TypesInWords& types, const LimitsInWords& limits) {
    long long particles = 0;
    for (const auto& s : scene.phases)
        particles += s.size();
    std::string out = text("Scene in ", dim, "D, ", sizeof(Real) == 4 ? "float" : "double", " in packs of ",
                           scene.width, ", ", scene.threads, scene.threads == 1 ? " thread" : " threads", ", ",
                           particles, " particles, support radius ", settings.support_radius * 1e3, " mm\n");
    for (std::size_t k = 0; k < scene.phases.size(); ++k) {
        const auto& s = scene.phases[k];
        const PhaseNumbers numbers = s.numbers();
        out += text("  ", s.name, ": ", s.size(), " particles, spacing ", numbers.spacing * 1e3, " mm, support radius ",
                    numbers.support_radius * 1e3, " mm, ", static_cast<std::size_t>(s.row->components) * sizeof(Real),
                    " bytes each\n    material: ", types.phases[k].material, "\n    effects: ", types.phases[k].effects,
                    "\n    fields:  ");
        for (std::size_t f = 0; f < s.row->fields.size(); ++f)
            out.append(f == 0 ? "" : ", ").append(s.row->fields[f].name);
        out += text("\n    sweeps:  ", types.phases[k].sweeps, " a step\n") + stiffness_in_words(s, types.phases[k]);
    }
    for (std::size_t k = 0; k < types.couplings.size(); ++k) {
        const CouplingRow& row = scene.table.couplings[k];
        out += text("  ", scene.coupling_names[k], " (", scene.phase(row.first).name, ", ",
                    scene.phase(row.second).name, "): ", types.couplings[k], "\n");
    }
    out += uncoupled_in_words(scene);
    out += text("Schedule: ", types.rounds, " rounds, ", types.loops,
                " loops\nMemory: ", static_cast<double>(scene.particle_bytes()) * 1e-6, " MB for particles, ",
                static_cast<double>(scene.list_bytes()) * 1e-6, " MB for neighbours\n");
    for (std::size_t k = 0; k < scene.links.size(); ++k) {
        const LinkRow& row = scene.links[k].row;
        const double mean = scene.mean_neighbours(scene.links[k]), support = scene.links[k].support;
        if (mean > 0)
            out += text("Neighbours: ", scene.phase(row.a).name, " has ", mean, " of ", scene.phase(row.b).name,
                        row.reference ? " (reference)" : "",
                        row.term == nullptr ? "" : text(" (", row.term(), ", ", support * 1e3, " mm)"), " on average; ",
                        types.loads[k], " numbers of each are loaded in a step\n");
    }
    out += "Time step:" + limits_in_words(limits.step);
    if (!limits.substep.empty())
        out += "\n  within it:" + limits_in_words(limits.substep);
    out += text("\n  first step ", limits.first.seconds, " s, from ", limits.first.reason, " (", limits.first.where,
                ")\n");
    return out + advice_in_words(scene, settings, types, limits);
}

} // namespace imbibe::detail
