// What is looked at before a scene runs: do the terms agree with their coefficients and materials, is a phase's support
// radius wide enough, and do coupled phases overlap?
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/phase.hpp>
#include <imbibe/geometry/point.hpp>

#include <string>

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
        (check(std::type_identity<typename Unwrapped<Term>::type>{}), ...);
    else
        (check(std::type_identity<Term>{}), ...);
}

/// A sentence if a particle of a square or cubic lattice has too few neighbours, or an empty one.
/// @param ratio the support radius in spacings
template <int dim>
std::string warning_of_few_neighbours(double ratio, const std::string& name) {
    if (ratio >= 1.3)
        return {};
    int neighbours = -1; // the particle itself is not one
    const int reach = static_cast<int>(ratio) + 1;
    for (int x = -reach; x <= reach; ++x)
        for (int y = -reach; y <= reach; ++y)
            for (int z = dim == 3 ? -reach : 0; z <= (dim == 3 ? reach : 0); ++z)
                neighbours += x * x + y * y + z * z < ratio * ratio * (1 - 1e-9);
    return text(name, ": the support radius is ", ratio, " spacings, so a particle has only ", neighbours,
                " neighbours and gradients come out too small; 2 to 3 spacings are usual");
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
                " of their mean spacing, at ", point_text<Engine::dimension>(place), ". What pushes them apart may throw them; half a ",
                "spacing from face to face is usual. `fill(a - b, spacing)` and `remove_if` leave out what is in the ",
                "other's way");
}

} // namespace imbibe::detail
