// What is looked at before a scene runs: do the terms agree with their coefficients and materials, is a phase's support
// radius wide enough, and do coupled phases overlap?
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/phase.hpp>
#include <imbibe/geometry/point.hpp>

#include <cmath>
#include <string>
#include <type_traits>

namespace imbibe::detail {

/// Asks a term whether the coefficients of its owner (a phase or a coupling), and the owner itself, are what it needs.
template <class Term, class Owner>
void check_term(const Owner& owner, const std::string& name) {
    if constexpr (requires { typename Term::Parameters; }) {
        const auto& parameters = owner.coefficients.template get<typename Term::Parameters>();
        if constexpr (requires { parameters.check(name); })
            parameters.check(name);
    }
    if constexpr (requires { Term::check(owner, name); })
        Term::check(owner, name);
}
template <class Where, class Owner, class... Term>
void check_terms(const Owner& owner, TypeList<Term...>) {
    // What is no term, as Into in a phase, is an error of its own.
    [[maybe_unused]] const auto check = [&]<class T>(std::type_identity<T>) {
        if constexpr (IsTerm<T>)
            check_term<T>(owner, type_name<Where>());
    };
    if constexpr (requires { typename Owner::First; })
        (check(std::type_identity<typename Listed<Term>::Term>{}), ...);
    else
        (check(std::type_identity<Term>{}), ...);
}

/// Throws Error unless particles that are added to a phase are of the material, the spacing and the support radius (m)
/// that it has: its material as it is, that of the new ones, theirs, and the name of the phase.
void require_same_material(const auto& phase, const auto& material, double spacing, double support,
                           const std::string& name) {
    const auto check = [&](double before, double now, const char* what, const char* unit) {
        require(before == now, name, ": particles were added with ", what, " ", before, " ", unit, " before and ", now,
                " ", unit, " now; use a second phase for a second material or spacing");
    };
    check(phase.spacing, spacing, "spacing", "m");
    check(phase.density, material.density, "density", "kg/m^3");
    check(phase.sound_speed, material.sound_speed, "sound speed", "m/s");
    check(phase.support_radius, support, "support radius", "m");
    if constexpr (requires { material.viscosity; })
        check(phase.viscosity, material.viscosity, "viscosity", "Pa s");
    if constexpr (requires { material.shear_modulus; })
        check(phase.shear_modulus, material.shear_modulus, "shear modulus", "Pa");
}

/// A sentence if a particle of a square or cubic lattice has too few neighbours, or so many that units were mixed up,
/// or an empty one.
/// @param ratio the support radius in spacings
template <int dim>
std::string warning_of_support(double ratio, const std::string& name) {
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

/// A sentence if particles of two phases that see each other start nearer than 0.3 of their mean spacing, or an empty
/// one. No error, even where they coincide: phases that drag or heat each other may well be in the same place.
/// @param link the phases' link, @param engine the scene it belongs to, @param origin of its coordinates, m
template <class Link, class Engine, class Origin>
std::string warning_of_overlap(const Link& link, const Engine& engine, const Origin& origin) {
    const auto& a = engine.template state<typename Link::A>();
    const auto& b = engine.template state<typename Link::B>();
    const auto pairs = engine.pairs_of(link);
    const double spacing = 0.5 * (a.material.spacing + b.material.spacing);
    if (!(pairs.nearest(engine.threads) < 0.3 * spacing))
        return {};
    int i = 0; // of the nearest pair
    double least = pairs.nearest_of(0).second;
    for (int k = 1; k < a.size(); ++k)
        if (const double distance = pairs.nearest_of(k).second; distance < least) {
            i = k;
            least = distance;
        }
    Point<Engine::dimension> place;
    for (int d = 0; d < Engine::dimension; ++d) {
        const auto axis = static_cast<std::size_t>(d);
        place[d] = static_cast<double>(a.points().x[axis][i]) + origin[axis];
    }
    return text(type_name<typename Link::A>(), " and ", type_name<typename Link::B>(),
                " overlap at the start: one pair is ", least, " m apart, ", least / spacing,
                " of their mean spacing, at ", point_text<Engine::dimension>(place),
                ". What pushes them apart may throw them; half a ",
                "spacing from face to face is usual. `fill(a - b, spacing)` and `remove_if` leave out what is in the ",
                "other's way");
}

/// Does one of some couplings tie phases A and B together?
template <class A, class B, class... C>
constexpr bool are_coupled(TypeList<C...>) {
    return (((std::is_same_v<A, typename C::First> && std::is_same_v<B, typename C::Second>) ||
             (std::is_same_v<B, typename C::First> && std::is_same_v<A, typename C::Second>)) ||
            ...);
}

/// A sentence if particles of a phase are not as far apart as the spacing that they were added with, which gives their
/// mass, or an empty one. The nearest one is a spacing away on square and cubic lattices, 1.12 on a face-centred one,
/// and 0.6 where particles of a lattice are moved at random by up to 0.3 spacings.
/// @param link of the phase to itself
template <class Link, class Engine>
std::string warning_of_other_spacing(const Link& link, const Engine& engine) {
    using P = typename Link::A;
    const double spacing = engine.template state<P>().material.spacing;
    const double apart = engine.pairs_of(link).median_nearest();
    if (apart == 0 || (apart > 0.5 * spacing && apart < 1.4 * spacing))
        return {};
    return text(type_name<P>(), ": its particles were added with a spacing of ", spacing, " m, and the next one is ",
                apart, " m away (the median). Each has the mass density * spacing^dim, so the spacing must be that of ",
                "the points");
}

/// A sentence if a fluid lies beside another phase and is not coupled to it, or an empty one.
/// @param engine after a search
template <class A, class B, class Couplings, class Engine>
std::string warning_of_no_coupling(const Engine& engine) {
    if constexpr (is_fluid<A> && !std::is_same_v<A, B> && !are_coupled<A, B>(Couplings{}))
        if (!engine.template are_apart<A, B>()) {
            std::string fluid = type_name<A>(), other = type_name<B>();
            if (is_fluid<B> && other < fluid) // the same sentence for both
                std::swap(fluid, other);
            return text(other, " is within reach of ", fluid, ", which does not see it: the two have ",
                        "no coupling. List one in the solver, as in struct Sides : Coupling<", fluid, ", ", other,
                        ", ...>");
        }
    return {};
}

/// A sentence if a coupling pushes a fluid by pressure, and the fluid's density, which follows from its motion, does
/// not count the other phase, or an empty one. The pressure then does not rise where the fluid comes nearer, and it
/// goes through, unless there is a repulsion, which rises by itself.
/// @param engine after a search
template <class C, class P, class Engine>
std::string warning_of_no_continuity(const Engine& engine) {
    using Other = std::conditional_t<std::is_same_v<P, typename C::First>, typename C::Second, typename C::First>;
    using Terms = typename C::terms;
    if constexpr (is_fluid<P> && has_effect_on<P, effects::continuity_equation>(typename P::terms{}) &&
                  has_effect_on<P, effects::pressure_force>(Terms{}) &&
                  !has_effect_on<P, effects::continuity_equation>(Terms{}) && !asks_for_nearest(Terms{}))
        if (!engine.template are_apart<P, Other>()) {
            const std::string fluid = type_name<P>(), other = type_name<Other>(), coupling = type_name<C>();
            return text(coupling, " pushes ", fluid, " by pressure, but the density of ", fluid, " does not count ",
                        other, ", so that the pressure does not rise where the two come nearer. List the ", fluid,
                        "'s continuity equation in ", coupling, " too, as in Into<", fluid, ", VolumeContinuity<K>>");
        }
    return {};
}

/// A sentence if a fluid is compressed by a twentieth under its own weight, or an empty one.
/// @param engine after a search
template <class P, class Engine>
std::string warning_of_soft_fluid(const Engine& engine) {
    if constexpr (is_fluid<P>) {
        const auto& s = engine.template state<P>();
        double potential = 0; // of the highest particle over the lowest, m^2/s^2
        for (std::size_t d = 0; d < static_cast<std::size_t>(Engine::dimension) && s.size() > 0; ++d)
            if (engine.periodic.length[d] == 0)
                potential += std::abs(engine.gravity[static_cast<int>(d)]) * (s.bounds.upper[d] - s.bounds.lower[d]);
        if (const double share = potential / sq(s.material.sound_speed); share > 0.05)
            return text(type_name<P>(), ": with a sound speed of ", s.material.sound_speed, " m/s its weight alone ",
                        "compresses it by ", 100 * share, " % at the bottom; ", std::sqrt(200 * potential),
                        " m/s, ten times the speed of a fall from top to bottom, is usual");
    }
    return {};
}

/// A sentence if two fluids that meet have different support radii, or an empty one.
template <class C, class Engine>
std::string warning_of_other_support(const Engine& engine) {
    using A = typename C::First;
    using B = typename C::Second;
    if constexpr (is_fluid<A> && is_fluid<B>) {
        const auto& a = engine.template state<A>();
        const auto& b = engine.template state<B>();
        const double of_a = a.material.support_radius, of_b = b.material.support_radius;
        if (a.size() > 0 && b.size() > 0 && std::abs(of_a - of_b) > 1e-9 * (of_a + of_b))
            return text(type_name<A>(), " and ", type_name<B>(), " have support radii of ", of_a, " and ", of_b,
                        " m; sums over each other reach the greater one, so that pushes from both sides do not cancel ",
                        "in the other fluid; give both the same");
    }
    return {};
}

/// Throws Error if two couplings give different coefficients to one part of one phase, which both ask for.
template <class P, class Term, class C, class D>
void check_shared(const C& one, const D& other) {
    if constexpr (requires { typename Term::Parameters; }) {
        using Parameters = typename Term::Parameters;
        if constexpr (requires(const Parameters& p) { p == p; })
            require(one.coefficients.template get<Parameters>() == other.coefficients.template get<Parameters>(),
                    type_name<C>(), " and ", type_name<D>(), " give ", type_name<P>(), " different ",
                    type_name<Parameters>(), ", and both count in one ", type_name<Term>(),
                    "; set the same in both couplings");
    }
}
/// The same for all terms of two couplings.
template <class C, class D, class... TermC>
void check_shared_parts(const C& one, const D& other, TypeList<TermC...>) {
    [[maybe_unused]] const auto check = [&]<class P, class Term>(std::type_identity<Into<P, Term>>) {
        if constexpr (contains<Into<P, Term>, typename D::terms>)
            check_shared<P, Term>(one, other);
    };
    [[maybe_unused]] const auto each = [&]<class T>(std::type_identity<T> term) {
        if constexpr (!std::is_same_v<T, typename Listed<T>::Term>)
            check(term);
    };
    (each(std::type_identity<TermC>{}), ...);
}

} // namespace imbibe::detail
