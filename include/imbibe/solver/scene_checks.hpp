// What is looked at before a scene runs: do the terms agree with their coefficients and materials, and is a phase's
// support radius wide enough?
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/phase.hpp>

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
    (check_term<typename Unwrapped<Term>::type>(owner, type_name<Where>()), ...);
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

} // namespace imbibe::detail
