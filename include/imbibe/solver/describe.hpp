// A report of a scene in words: effects, fields, bytes, rounds and sweeps, neighbours, limits of the step.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/core/lattice.hpp>
#include <imbibe/solver/costs.hpp>
#include <imbibe/solver/limit_rows.hpp>
#include <imbibe/solver/nodes.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/solver/time_step_limits.hpp>
#include <imbibe/time/dual_stepping.hpp>

#include <chrono>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace imbibe {

namespace detail {

/// The compiler's signature of this function, which contains the name of T.
template <class T>
constexpr std::string_view signature() {
    return __PRETTY_FUNCTION__;
}
/// The names of types in their signatures, with their template arguments, without the library's namespaces. (clang++
/// omits default arguments, `PressureExtrapolation<>`, and does not name fields in template arguments.)
std::string type_names(std::initializer_list<std::string_view> signatures);
template <class... Term>
std::string names_of(TypeList<Term...>) {
    return type_names({signature<Term>()...});
}

/// The share of a pressure that resists slow shear of a phase, by the kernel of its plain pressure force
/// (`pressure_kernel`); 0 if it has none, or the kernel has no second derivative.
template <int dim, class P>
double shear_stiffness_of(const P&, TypeList<>) {
    return 0;
}
template <int dim, class P, class First, class... Rest>
double shear_stiffness_of(const P& material, TypeList<First, Rest...>) {
    const Lattice<dim> lattice{material.spacing, material.support_radius};
    if constexpr (requires(double q) { First::pressure_kernel::second_derivative(q); })
        return lattice.template shear_stiffness<typename First::pressure_kernel>();
    else
        return shear_stiffness_of<dim>(material, TypeList<Rest...>{});
}

/// Pa s; 0 for a phase without.
double viscosity_of(const auto& material) {
    if constexpr (requires { material.viscosity; })
        return material.viscosity;
    else
        return 0;
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

/// The terms that DualStepping may evaluate in long steps: those that shift particles, and physical viscosities.
template <class Term>
concept ShiftsParticles = requires {
    Term::advection_limit_name;
};
template <class Term>
concept IsViscous = requires {
    requires std::is_same_v<typename Term::effect, effects::viscous_force>;
};
template <class Term>
struct KeepSlow : std::bool_constant<ShiftsParticles<Term> || IsViscous<Term>> {};
/// Such terms of a list, without the phases that they are listed for.
template <class List>
struct SlowTermsIn;
template <class... Term>
struct SlowTermsIn<TypeList<Term...>> {
    using type = Filter<KeepSlow, TypeList<typename Listed<Term>::Term...>>;
};
/// Those of the phases and couplings of a scene.
template <class Phases, class Couplings>
struct SlowTerms;
template <class... P, class... C>
struct SlowTerms<TypeList<P...>, TypeList<C...>> {
    using type = Unique<
        Concat<typename SlowTermsIn<typename P::terms>::type..., typename SlowTermsIn<typename C::terms>::type...>>;
};
/// DualStepping with the terms of a list. Are particles shifted by one of them?
template <class List>
struct DualSteppingOf;
template <class... Term>
struct DualSteppingOf<TypeList<Term...>> {
    using type = DualStepping<Term...>;
    static constexpr bool shifts = (ShiftsParticles<Term> || ...);
};

/// The part of a scene's report that depends on its types.
struct TypesInWords {
    struct PhaseInWords {
        std::string material, effects;
        int sweeps = 0;             ///< per step
        double shear_stiffness = 0; ///< share of a pressure that resists slow shear
        double viscosity = 0;       ///< Pa s
    };
    std::vector<PhaseInWords> phases;
    std::vector<std::string> couplings; ///< their effects
    std::vector<int> loads;             ///< by link: how many numbers of a neighbour are loaded in a step
    int rounds = 0, loops = 0;
    /// Where particles are shifted: DualStepping with its long steps, and the numbers that are loaded in long and in
    /// short ones, by link.
    struct {
        std::string integrator;
        double step = 0; ///< the shortest limit on long steps, without the CFL number, s; 0: none
        std::vector<int> loads, loads_in_short;
    } dual;
};
/// The limits on steps, for the report.
struct LimitsInWords {
    std::vector<TimeStepLimit> step, substep;
    TimeStepLimit first{0, "", ""}; ///< the limit on the first step
};

/// The report of a prepared scene.
template <int dim, class Real>
std::string describe_scene(const Neighbourhood<dim, Real>& scene, const Settings<dim>& settings,
                           const TypesInWords& types, const LimitsInWords& limits);

} // namespace detail

/// The report of a scene: its effects, the fields of a particle, the schedule, the number of neighbours, pairs of
/// phases without interaction, limits of the time step, and ways to make the scene faster. Prepares the scene for its
/// first step.
template <class Scene>
std::string describe(Scene& scene) {
    using Costs = imbibe::Costs<Scene>;
    scene.prepare();
    const auto& engine = scene.engine();
    detail::TypesInWords types{
        .phases = {}, .couplings = {}, .loads = {}, .rounds = Costs::rounds, .loops = Costs::loops, .dual = {}};
    engine.for_each_phase([&]<class P>(std::type_identity<P>, const auto& s) {
        types.phases.push_back(
            {.material = detail::material_in_words(s.material),
             .effects = detail::names_of(typename P::terms{}),
             .sweeps = Costs::template sweeps<P>,
             .shear_stiffness = detail::shear_stiffness_of<Scene::dimension>(s.material, typename P::terms{}),
             .viscosity = detail::viscosity_of(s.material)});
    });
    [&]<class... C>(TypeList<C...>) {
        (types.couplings.push_back(detail::names_of(typename C::terms{})), ...);
    }(typename Scene::Couplings{});
    engine.for_each_link(
        [&]<class L>(L, const detail::Link&) { types.loads.push_back(Costs::template loads_of_link<L>); });
    using Composition = typename Scene::Scene;
    using Slow = typename detail::SlowTerms<typename Scene::Phases, typename Scene::Couplings>::type;
    if constexpr (detail::DualSteppingOf<Slow>::shifts && !Scene::subcycles) {
        using Dual = typename detail::DualSteppingOf<Slow>::type;
        types.dual.integrator = detail::names_of(TypeList<Dual>{});
        if (const auto all =
                detail::limits_of(engine, detail::LimitRows<Scene::dimension, Composition, Dual>::rows, false);
            !all.empty()) // it is where nothing moves
            types.dual.step = all.front().seconds;
        engine.for_each_link([&]<class L>(L, const detail::Link&) {
            const auto loads = [](const auto& pass) {
                return detail::PassLoads<Scene::dimension, std::remove_cvref_t<decltype(pass)>>::template loads<L>;
            };
            types.dual.loads.push_back(loads(typename Composition::template TermsOf<Slow>{}));
            types.dual.loads_in_short.push_back(loads(typename Composition::template AllButTermsOf<Slow>{}));
        });
    }
    detail::LimitsInWords limits{scene.time_step_limits(), {}, scene.next_step()};
    if constexpr (Scene::subcycles)
        limits.substep = scene.substep_limits();
    std::string out = detail::describe_scene(engine, scene.settings(), types, limits);
#ifndef __OPTIMIZE__
    out += "Warning: compiled without optimisation, which is many times slower; give the compiler -O3 "
           "-march=native, or CMake -DCMAKE_BUILD_TYPE=Release\n";
#endif
    return out;
}

/// The wall time of the run to `end` at the pace of `steps` steps of a copy of the scene, s. Later contacts and leaving
/// particles are not foreseen. Of a scene whose first steps fail, at the pace of those before; 0 if there are none. The
/// run itself says what failed.
template <class Scene>
double estimate_wall_seconds(const Scene& scene, double end, int steps = 4) {
    Scene copy = scene;
    auto started = std::chrono::steady_clock::now();
    double begin = copy.time(), wall = 0;
    try {
        for (int k = 0; k <= steps; ++k) {
            copy.step();
            const auto now = std::chrono::steady_clock::now();
            if (k == 0) { // it does what is done once
                started = now;
                begin = copy.time();
            }
            wall = std::chrono::duration<double>(now - started).count();
        }
    } catch (const Error&) {
    }
    return copy.time() > begin ? wall * (end - scene.time()) / (copy.time() - begin) : 0;
}

} // namespace imbibe

#if IMBIBE_READS_CODE
#include <imbibe/solver/describe_code.hpp>
#endif
