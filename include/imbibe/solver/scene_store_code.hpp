// The code of scene_store.hpp: makes a scene of its tables.
#pragma once

#include <imbibe/solver/scene_store.hpp>

namespace imbibe::detail {

template <int dim, class Real>
SceneStore<dim, Real>::SceneStore(const SceneTable& of, std::span<const Reduction<dim, Real>> of_terms)
    : table(of), reductions(of_terms) {
    for (const PhaseRow& row : table.phases)
        phases.emplace_back(row);
    seen.resize(phases.size());
    for (const CouplingRow& row : table.couplings) {
        couplings.push_back(row.coupling());
        coupling_names.push_back(row.name());
    }
    for (const LinkRow& row : table.links)
        links.push_back({.row = row, .runs = {}, .stencils = {}});
}

template <int dim, class Real>
void SceneStore<dim, Real>::set_periodic(const search::Periodic<dim>& sides) {
    periodic = sides;
    for (int shift = 0; shift < search::image_count<dim>; ++shift)
        for (int d = 0; d < dim; ++d)
            images[static_cast<std::size_t>(shift)][d] =
                static_cast<Real>(search::image_step(shift, d) * periodic.length[static_cast<std::size_t>(d)]);
}

template <int dim, class Real>
double SceneStore<dim, Real>::support(int a, int b) const {
    const double of_a = phase(a).numbers().support_radius, of_b = phase(b).numbers().support_radius;
    if (phase(a).row->fluid != phase(b).row->fluid)
        return phase(a).row->fluid ? of_a : of_b;
    return std::max(of_a, of_b);
}

template <int dim, class Real>
double SceneStore<dim, Real>::support_of(const LinkRow& row) const {
    if (row.support_of_term == nullptr)
        return row.reference ? phase(row.a).numbers().support_radius : support(row.a, row.b);
    if (row.coupling < 0)
        return row.support_of_term(phase(row.a).material, phase(row.a).material, phase(row.a).material);
    const CouplingRow& coupling = table.couplings[static_cast<std::size_t>(row.coupling)];
    return row.support_of_term(couplings[static_cast<std::size_t>(row.coupling)], phase(coupling.first).material,
                               phase(coupling.second).material);
}

template <int dim, class Real>
double SceneStore<dim, Real>::longest_support(int a, int b) const {
    double longest = support(a, b);
    for (const Link& link : links)
        if (const LinkRow& row = link.row; row.support_of_term != nullptr && !row.reference &&
                                           ((row.a == a && row.b == b) || (row.a == b && row.b == a)))
            longest = std::max(longest, support_of(row));
    return longest;
}

} // namespace imbibe::detail
