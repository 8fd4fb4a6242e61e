// Phases (a material with its list of terms) and couplings (the terms between two phases), as a user declares them:
//   struct Water : imbibe::Fluid<imbibe::Tait<>, ...> {};
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/method.hpp>
#include <imbibe/core/term.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <tuple>

namespace imbibe {

/// Marks a number that the user has to give.
inline constexpr double required = -1;

namespace detail {

template <class List>
struct TupleOf;
template <class... T>
struct TupleOf<TypeList<T...>> {
    using type = std::tuple<T...>;
};

// The parameters that fill a part, as the type of its member of that name; void if it has none.
template <class Part>
struct ParametersIn {
    using type = void;
};
template <class Part>
requires requires(const Part& part) {
    part.parameters;
}
struct ParametersIn<Part> {
    using type = std::remove_cvref_t<decltype(Part::parameters)>;
};
/// Is a part of the term filled with these parameters?
template <class Parameters, class Parts>
inline constexpr bool fills_a_part = false;
template <class Parameters, class... P>
inline constexpr bool
    fills_a_part<Parameters, TypeList<P...>> = (std::is_same_v<typename ParametersIn<P>::type, Parameters> || ...);

template <class Term>
struct ParametersOf {
    using type = TypeList<>;
};
template <class Term>
    requires requires { typename Term::Parameters; }
struct ParametersOf<Term> {
    using type = TypeList<typename Term::Parameters>;
};

template <class Term>
struct PreparedOf {
    using type = TypeList<>;
};
template <Prepares Term>
struct PreparedOf<Term> {
    using type = TypeList<typename Term::Prepared>;
};

/// The name of the type T within a function name as compilers print it: the text after the last :: outside brackets,
/// without template arguments.
inline std::string name_in(std::string_view function) {
    std::size_t begin = function.find("T = ") + 4, end = begin, arguments = std::string_view::npos;
    for (int depth = 0; end < function.size(); ++end) {
        const char c = function[end];
        if (depth == 0 && (c == ';' || c == ']'))
            break;
        if (depth == 0 && c == ':') {
            begin = end + 1;
            arguments = std::string_view::npos;
        } else if (depth == 0 && c == '<') {
            arguments = std::min(arguments, end);
        }
        depth += (c == '<' || c == '(' || c == '[' || c == '{') - (c == '>' || c == ')' || c == ']' || c == '}');
    }
    return std::string(function.substr(begin, std::min(arguments, end) - begin));
}

/// The name of a type as the user wrote it, without namespaces and template arguments.
template <class T>
std::string type_name() {
    return name_in(__PRETTY_FUNCTION__);
}

/// The name of phase P among those of a scene, as `spelled` has it. If another phase has the same name, such as
/// `Body<0>` and `Body<1>`, its number in the list is appended.
template <class P, class... All, class Spelled = std::identity>
std::string name_among(TypeList<All...>, const Spelled& spelled = {}) {
    const std::string name = spelled(type_name<P>());
    int same = 0, number = 0, k = 0;
    const auto count = [&](const std::string& other, bool itself) {
        ++k;
        same += other == name;
        if (itself)
            number = k;
    };
    (count(spelled(type_name<All>()), std::is_same_v<All, P>), ...);
    return same > 1 ? text(name, "_", number) : name;
}

inline void require_positive(double value, std::string_view phase, std::string_view name, std::string_view unit) {
    require(std::isfinite(value) && value > 0, phase, ": ", name, " = ", value, " ", unit,
            value == required ? " (not given)" : "", "; it must be a finite number above 0 ", unit,
            ". Give it where the phase is made, as in ", phase, "{{.", name, " = ...}}");
}

} // namespace detail

struct list_the_term_that_they_are_of;
struct write_using_Parameters_in_the_term;
namespace rules {
/// Rule: parameters can be given only to a phase or coupling that lists the term they belong to.
template <class Parameters, class TheirsAre, class Advice>
struct NoTermHasTheseParameters {
    static_assert(sizeof(Parameters) == 0, "imbibe: no term of this phase or coupling has these parameters");
};
/// Rule: a term whose parts are filled with parameters says of which type they are.
template <class Parameters, class Term, class Advice>
struct ParametersNotDeclared {
    static_assert(sizeof(Parameters) == 0,
                  "imbibe: this term has a member `parameters` of this type, and no `using Parameters` of it");
};
} // namespace rules

/// The numerical coefficients of a list of terms: one value of each term's `Parameters`, and of each term's `Prepared`.
template <class... Terms>
struct Coefficients {
    /// The types of the coefficients, each once.
    using List = detail::Unique<detail::Concat<typename detail::ParametersOf<Terms>::type...>>;
    /// Their values.
    typename detail::TupleOf<List>::type all{};
    /// What terms computed from them: one value of each term's `Prepared`.
    typename detail::TupleOf<detail::Unique<detail::Concat<typename detail::PreparedOf<Terms>::type...>>>::type
        prepared{};

    /// The parameters of type P, to read or to change: `phase.coefficients.get<ArtificialStressParameters>()`.
    template <class P>
    constexpr P& get() {
        return *find<P>(all);
    }
    /// The same, to read.
    template <class P>
    constexpr const P& get() const {
        return *find<P>(all);
    }

private:
    template <class P>
    static constexpr auto find(auto& values) {
        if constexpr (detail::contains<P, List>) {
            return &std::get<P>(values);
        } else {
            explain<P, Terms...>();
            return &detail::nothing<P>();
        }
    }
    // Why there are none of type P: no term declares them as its own.
    template <class P>
    static constexpr void explain() {
        detail::break_rule<rules::NoTermHasTheseParameters<P, List, list_the_term_that_they_are_of>>();
    }
    template <class P, class Term, class... Rest>
    static constexpr void explain() {
        if constexpr (detail::fills_a_part<P, detail::PartList<Term>>)
            detail::break_rule<rules::ParametersNotDeclared<P, Term, write_using_Parameters_in_the_term>>();
        else
            explain<P, Rest...>();
    }
};

namespace detail {
template <class List>
struct CoefficientsIn;
template <class... T>
struct CoefficientsIn<TypeList<T...>> {
    using type = Coefficients<typename Listed<T>::Term...>;
};
} // namespace detail

/// Particles move as the forces on them say. Fluids and solids.
struct Free {};
/// Particles move with a velocity that a term sets (from `a.time`, say) or a program writes. The integrator advances
/// their positions with it; forces do not act on them. `struct Paddle : Wall<...> { using motion = Prescribed; };`
struct Prescribed {};
/// Particles do not move, unless a program writes their positions, and with them their velocities. Walls.
struct Placed {};

namespace detail {
/// Does the integrator advance the positions of phase P?
template <class P>
inline constexpr bool drifts = !std::is_same_v<typename P::motion, Placed>;
} // namespace detail

/// A fluid: its material and, as template arguments, its terms and methods.
template <class... Terms>
struct Fluid {
    using written = TypeList<Terms...>;                     ///< as it stands in the program
    using terms = typename detail::TermsIn<Terms...>::type; ///< without methods
    using motion = Free;                                    ///< how its particles move
    static constexpr bool moves = true;

    double density = required;     ///< reference density rho_0, kg/m^3
    double sound_speed = required; ///< speed of sound c in the equation of state, m/s; ten times the greatest speed
    double viscosity = 0;          ///< dynamic viscosity eta, Pa s
    double support_radius = 0;     ///< H of this phase, m; 0: the scene's. Its sums over walls and solids, and theirs
                                   ///< over it, reach as far; those between two fluids the greater H of the two
    double spacing = 0;            ///< particle spacing, m; set when particles are added
    typename detail::CoefficientsIn<terms>::type coefficients{}; ///< of the terms

    /// Replaces the coefficients of one term.
    template <class P>
    constexpr void set(const P& parameters) {
        coefficients.template get<P>() = parameters;
    }
    /// Throws Error for a number out of range. @param name what the phase is called in the message
    void check(std::string_view name) const {
        detail::require_positive(density, name, "density", "kg/m^3");
        detail::require_positive(sound_speed, name, "sound_speed", "m/s");
        require_not_negative(viscosity, name, "viscosity", "Pa s");
    }
};

/// An elastic solid: its material, and its terms and methods.
template <class... Terms>
struct Solid {
    using written = TypeList<Terms...>;                     ///< as it stands in the program
    using terms = typename detail::TermsIn<Terms...>::type; ///< without methods
    using motion = Free;                                    ///< how its particles move
    static constexpr bool moves = true;

    double density = required;       ///< density of the stress-free solid, kg/m^3
    double sound_speed = required;   ///< bulk speed of sound c = sqrt(K / rho), m/s
    double shear_modulus = required; ///< shear modulus G, Pa
    double support_radius = 0;       ///< H of this phase, m; 0: the scene's
    double spacing = 0;              ///< particle spacing, m; set when particles are added
    typename detail::CoefficientsIn<terms>::type coefficients{}; ///< of the terms

    template <class P>
    constexpr void set(const P& parameters) {
        coefficients.template get<P>() = parameters;
    }
    /// K = rho c^2, Pa
    constexpr double bulk_modulus() const { return density * sound_speed * sound_speed; }
    /// nu = (3K - 2G) / (6K + 2G)
    constexpr double poisson_ratio() const {
        return (3 * bulk_modulus() - 2 * shear_modulus) / (6 * bulk_modulus() + 2 * shear_modulus);
    }
    /// E = 9KG / (3K + G), Pa
    constexpr double young_modulus() const {
        return 9 * bulk_modulus() * shear_modulus / (3 * bulk_modulus() + shear_modulus);
    }
    /// Speed of longitudinal waves, sqrt((K + 4G/3) / rho), m/s
    double longitudinal_wave_speed() const { return std::sqrt((bulk_modulus() + 4 * shear_modulus / 3) / density); }

    void check(std::string_view name) const {
        detail::require_positive(density, name, "density", "kg/m^3");
        detail::require_positive(sound_speed, name, "sound_speed", "m/s");
        detail::require_positive(shear_modulus, name, "shear_modulus", "Pa");
    }
    /// A sentence if the moduli are legal but unusual; empty otherwise.
    std::string warning(std::string_view name) const {
        const double nu = poisson_ratio();
        if (nu > 0.4999)
            return text(name, ": shear modulus ", shear_modulus, " Pa with bulk modulus ", bulk_modulus(),
                        " Pa is Poisson's ratio ", nu, ", practically a liquid; is the exponent right?");
        if (nu < -1e-9) // moduli of nu = 0 are rounded
            return text(name, ": shear modulus ", shear_modulus, " Pa with bulk modulus ", bulk_modulus(),
                        " Pa is Poisson's ratio ", nu, ", an auxetic solid");
        return {};
    }
};

/// A wall: particles that no force moves, with the terms they need to push on a fluid. It rests, moves with a velocity
/// that a term sets or a program writes (`using motion = Prescribed;`), or is placed by a program, which then writes
/// positions and velocities in every step, because the fluid's pressure follows from the velocities.
template <class... Terms>
struct Wall {
    using written = TypeList<Terms...>;                     ///< as it stands in the program
    using terms = typename detail::TermsIn<Terms...>::type; ///< without methods
    using motion = Placed;                                  ///< how its particles move; see Prescribed
    static constexpr bool moves = false;

    double density = required; ///< density the wall shows to the fluid (the fluid's own), kg/m^3
    double sound_speed = 1;    ///< speed of sound, for walls that have an equation of state, m/s
    double viscosity = 0;      ///< dynamic viscosity shown to the fluid, Pa s
    double support_radius = 0; ///< H, m; 0: the scene's
    double spacing = 0;        ///< particle spacing, m; set when particles are added
    typename detail::CoefficientsIn<terms>::type coefficients{}; ///< of the terms

    template <class P>
    constexpr void set(const P& parameters) {
        coefficients.template get<P>() = parameters;
    }
    void check(std::string_view name) const {
        detail::require_positive(density, name, "density", "kg/m^3");
        detail::require_positive(sound_speed, name, "sound_speed", "m/s");
        require_not_negative(viscosity, name, "viscosity", "Pa s");
    }
};

namespace detail {
// Does it act on phase P?
template <class P, class T>
inline constexpr bool acts_on = std::is_void_v<typename Listed<T>::On> || std::is_same_v<typename Listed<T>::On, P>;
// Does a term with the effect act on phase P in a phase or coupling with these terms?
template <class P, class Effect, class... T>
constexpr bool has_effect_on(TypeList<T...>) {
    [[maybe_unused]] const auto has = []<class Term>(std::type_identity<Term>) {
        return requires {
            requires std::is_same_v<typename Term::effect, Effect>;
        };
    };
    return ((acts_on<P, T> && has(std::type_identity<typename Listed<T>::Term>{})) || ...);
}
// Has a coupling with these terms one whose two phases may overlap?
template <class... T>
constexpr bool overlaps(TypeList<T...>) {
    [[maybe_unused]] const auto does = []<class Term>(std::type_identity<Term>) {
        return requires {
            requires Term::overlapping;
        };
    };
    return (does(std::type_identity<typename Listed<T>::Term>{}) || ...);
}
// Has a coupling with these terms one whose time step limit asks for the nearest pair? That is a repulsion.
template <class... T>
constexpr bool asks_for_nearest(TypeList<T...>) {
    [[maybe_unused]] const auto asks = []<class Term>(std::type_identity<Term>) {
        return requires {
            requires Term::limit_by_nearest;
        };
    };
    return (asks(std::type_identity<typename Listed<T>::Term>{}) || ...);
}
} // namespace detail

/// The terms between two phases.
template <class First_, class Second_, class... Terms>
struct Coupling {
    /// One of the two phases.
    using First = First_;
    /// The other one.
    using Second = Second_;
    using terms = typename detail::TermsIn<Terms...>::type; ///< without methods
    typename detail::CoefficientsIn<terms>::type coefficients{}; ///< of the terms

    template <class P>
    constexpr void set(const P& parameters) {
        coefficients.template get<P>() = parameters;
    }
};

namespace detail {
template <class A, class B, class Terms, class... More>
struct CouplingOfTerms;
template <class A, class B, class... T, class... More>
struct CouplingOfTerms<A, B, TypeList<T...>, More...> {
    using type = Coupling<A, B, T..., More...>;
};
template <class A, class B, class... More>
using CouplingByWritten =
    typename CouplingOfTerms<A, B, typename CouplingByMethods<A, B, typename A::written>::type, More...>::type;
} // namespace detail

/// The terms between a fluid and a wall, a solid or another fluid, as the fluid's methods define them, and `More`:
/// further terms, or Instead<...> to replace some of them here. `struct Sides : CouplingOf<Water, Tank> {};`
template <class Liquid, class Body, class... More>
struct CouplingOf : detail::CouplingByWritten<Liquid, Body, More...> {};

namespace detail {
// Throws for illegal elastic constants, with the function `where` in the message.
constexpr void check_elastic_constants(std::string_view where, double young_modulus, double poisson_ratio) {
    if (!(young_modulus > 0 && young_modulus < std::numeric_limits<double>::infinity()))
        refuse({where, ": Young's modulus = ", young_modulus,
                " Pa; it must be a finite number above 0 Pa (rubber 1e6, steel 2e11)"});
    if (!(poisson_ratio > -1 && poisson_ratio < 0.5))
        refuse(
            {where, ": Poisson's ratio = ", poisson_ratio,
             "; it must be above -1 and below 0.5, where sound is infinitely fast: take 0.45 to 0.49 for rubber (the "
             "time step falls as sqrt(1 - 2 nu))"});
}
} // namespace detail

/// Shear modulus from Young's modulus and Poisson's ratio, G = E / (2 (1 + nu)), Pa.
/// @throws Error unless E is above 0 Pa and nu above -1 and below 0.5
constexpr double shear_modulus_of(double young_modulus, double poisson_ratio) {
    detail::check_elastic_constants("shear_modulus_of", young_modulus, poisson_ratio);
    return young_modulus / (2 * (1 + poisson_ratio));
}
/// Bulk sound speed from Young's modulus and Poisson's ratio: c^2 = K / rho with K = E / (3 (1 - 2 nu)), m/s.
/// @throws Error unless E is above 0 Pa, nu above -1 and below 0.5, and the density rho above 0 kg/m^3
inline double sound_speed_of(double young_modulus, double poisson_ratio, double rho) {
    detail::check_elastic_constants("sound_speed_of", young_modulus, poisson_ratio);
    require(std::isfinite(rho) && rho > 0, "sound_speed_of: density = ", rho,
            " kg/m^3; it must be a finite number above 0 kg/m^3 (rubber 1100)");
    return std::sqrt(young_modulus / (3 * (1 - 2 * poisson_ratio)) / rho);
}

} // namespace imbibe
