// The code of scene_store.hpp: makes a scene of its tables.
#pragma once

#include <imbibe/solver/scene_store.hpp>

namespace imbibe::detail {

template <int dim, class Real>
SceneStore<dim, Real>::SceneStore(const SceneTable& of) : table(of) {
    for (const PhaseRow& row : table.phases)
        phases.emplace_back(row);
    for (const CouplingRow& row : table.couplings) {
        couplings.push_back(row.coupling());
        coupling_names.push_back(row.name());
    }
    for (const LinkRow& row : table.links)
        links.push_back({.row = row, .runs = {}});
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

} // namespace imbibe::detail
