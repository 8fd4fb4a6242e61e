// What a scene is made of, in words: effects, fields, bytes, rounds and sweeps, neighbours, limits of the step.
#pragma once

#include <imbibe/solver/costs.hpp>
#include <imbibe/solver/solver.hpp>

#include <chrono>
#include <sstream>

namespace imbibe {

namespace detail {

/// What the compiler calls this function: the name of T is in it.
template <class T>
constexpr std::string_view signature() {
    return __PRETTY_FUNCTION__;
}
/// The name of the type in a signature, with its template arguments, without the library's namespaces. (clang++ leaves
/// out arguments that are the default, `PressureExtrapolation<>`, and does not say which field one is.)
[[gnu::noinline]] inline std::string full_type_name(std::string_view function) {
    const auto begin = function.find("T = ") + 4;
    std::string all(function.substr(begin, function.find_last_of("];") - begin));
    all = all.substr(0, all.find("; std::string_view"));
    for (const char* noise :
         {"(anonymous namespace)::", "{anonymous}::", "imbibe::presets::", "imbibe::", ", {{}}", "{}", "()"})
        for (auto at = all.find(noise); at != std::string::npos; at = all.find(noise))
            all.erase(at, std::string_view(noise).size());
    return all;
}
[[gnu::noinline]] inline std::string type_names(std::initializer_list<std::string_view> signatures) {
    std::string names;
    for (const auto& one : signatures)
        names += (names.empty() ? "" : ", ") + full_type_name(one);
    return names.empty() ? "none" : names;
}
template <class... Term>
std::string names_of(TypeList<Term...>) {
    return type_names({signature<Term>()...});
}
[[gnu::noinline]] inline std::string listed(std::initializer_list<std::string_view> words) {
    std::string all;
    for (const auto& word : words)
        all.append(all.empty() ? "" : ", ").append(word);
    return all;
}
template <class... F>
std::string field_names(TypeList<F...>) {
    return listed({F::name...});
}
[[gnu::noinline]] inline std::string limits_in_words(const std::vector<TimeStepLimit>& limits) {
    std::string words;
    for (const TimeStepLimit& limit : limits)
        words += text(" ", limit.seconds, " s (", limit.reason, ", ", limit.where, ");");
    return words;
}

/// The numbers of a phase's material, in words.
template <class P>
std::string material_in_words(const P& material) {
    std::string words = text("density ", material.density, " kg/m^3");
    if (P::moves)
        words += text(", sound speed ", material.sound_speed, " m/s");
    if constexpr (requires { material.shear_modulus; })
        words += text(", shear modulus ", material.shear_modulus, " Pa (Young's modulus ", material.young_modulus(),
                      " Pa, Poisson's ratio ", material.poisson_ratio(), ")");
    else if (material.viscosity > 0)
        words += text(", viscosity ", material.viscosity, " Pa s");
    return words;
}

/// A line that names the pairs of phases between which nothing acts, or none.
inline std::string uncoupled_in_words(const OutlineOfScene& scene, const std::vector<PhasePair>& pairs) {
    std::string words;
    for (const PhasePair& pair : pairs)
        if (!pair.coupled)
            words += text(words.empty() ? "Nothing acts between: " : "; ", scene[pair.first].name, " and ",
                          scene[pair.second].name);
    return words.empty() ? words : words + "\n";
}

} // namespace detail

/// The report of a scene: which effects are on, what a particle stores, how the work is scheduled, how many neighbours
/// there are, between which phases nothing acts, and what limits the time step. Prepares the scene for its first step.
template <class Scene>
std::string describe(Scene& scene) {
    using Costs = imbibe::Costs<Scene>;
    using Real = typename Scene::Real;
    scene.prepare();
    std::string out =
        text("Scene in ", Scene::dimension, "D, ", sizeof(Real) == 4 ? "float" : "double", " in packs of ",
             Scene::width, ", ", scene.threads(), scene.threads() == 1 ? " thread" : " threads", ", ",
             scene.particles(), " particles, support radius ", scene.settings().support_radius * 1e3, " mm\n");
    const auto& engine = scene.engine();
    const typename Scene::Phases phases;
    engine.for_each_phase([&]<class P, class State>(std::type_identity<P>, const State& s) {
        out += text("  ", detail::name_among<P>(phases), ": ", s.size(), " particles, spacing ",
                    s.material.spacing * 1e3, " mm, support radius ", s.material.support_radius * 1e3, " mm, ",
                    State::component_total * sizeof(Real),
                    " bytes each\n    material: ", detail::material_in_words(s.material),
                    "\n    effects: ", detail::names_of(typename P::terms{}),
                    "\n    fields:  ", detail::field_names(typename Scene::template FieldsOf<P>{}),
                    "\n    sweeps:  ", Costs::template sweeps<P>, " a step\n");
    });
    const auto coupling = [&]<class C>(std::type_identity<C>) {
        out += text("  ", detail::name_among<C>(typename Scene::Couplings{}), " (",
                    detail::name_among<typename C::First>(phases), ", ", detail::name_among<typename C::Second>(phases),
                    "): ", detail::names_of(typename C::terms{}), "\n");
    };
    [&]<class... C>(TypeList<C...>) { (coupling(std::type_identity<C>{}), ...); }(typename Scene::Couplings{});
    out += detail::uncoupled_in_words(scene.outline(), detail::pairs_of_phases(engine));
    out += text("Schedule: ", Costs::rounds, " rounds, ", Costs::loops,
                " loops\nMemory: ", static_cast<double>(engine.particle_bytes()) * 1e-6, " MB for particles, ",
                static_cast<double>(engine.list_bytes()) * 1e-6, " MB for neighbours\n");
    engine.for_each_link([&]<class L>(L, const detail::Link& link) {
        const double mean = engine.mean_neighbours(link);
        if (mean > 0)
            out += text("Neighbours: ", detail::name_among<typename L::A>(phases), " has ", mean, " of ",
                        detail::name_among<typename L::B>(phases), L::reference ? " (reference)" : "", " on average; ",
                        Costs::template loads<typename L::A, typename L::B>, " numbers of each are loaded in a step\n");
    });
    out += "Time step:" + detail::limits_in_words(scene.time_step_limits());
    if constexpr (Scene::subcycles)
        out += "\n  within it:" + detail::limits_in_words(scene.substep_limits());
    const auto next = scene.next_step();
    out += text("\n  first step ", next.seconds, " s, from ", next.reason, " (", next.where, ")\n");
#ifndef __OPTIMIZE__
    out += "Warning: compiled without optimisation, which is many times slower; give the compiler -O3 "
           "-march=native, or CMake -DCMAKE_BUILD_TYPE=Release\n";
#endif
    return out;
}

/// How long the run to `end` would take at the pace of `steps` steps of a copy of the scene, wall seconds. Contacts
/// that come later, or particles that leave, are not foreseen.
template <class Scene>
double estimate_wall_seconds(const Scene& scene, double end, int steps = 4) {
    Scene copy = scene;
    copy.step();
    const double begin = copy.time();
    const auto started = std::chrono::steady_clock::now();
    for (int k = 0; k < steps; ++k)
        copy.step();
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    return wall * (end - scene.time()) / (copy.time() - begin);
}

} // namespace imbibe
