// A fluid that starts in the pores of a skeleton.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/mixture/porous_skeleton.hpp>
#include <imbibe/search/neighbour_search.hpp>

#include <algorithm>
#include <array>

namespace imbibe {

/// Reduces mass and density of fluid particles that were added in or near a skeleton to the share that fits into the
/// pores: both are multiplied by the porosity n of PoreSpace. The volume of a particle and the density of the fluid
/// itself, rho/n, do not change.
///
/// Call it once, after both were added, each with particles that fill its space: `scene.add(water, fill(box, dx), dx);
/// scene.add(sponge, fill(box, dx), dx); fill_pores(scene, water, sponge)`; and after start_hydrostatic, if the fluid
/// has weight.
/// @tparam Kernel that of PoreSpace
template <class Kernel = WendlandC2, class Scene, class Fluid, class Skeleton>
void fill_pores(Scene& scene, Fluid fluid, Skeleton skeleton) {
    constexpr int dim = Scene::dimension;
    const auto of = scene[fluid];
    const auto body = scene[skeleton];
    require(of.size() > 0 && body.size() > 0, "fill_pores: the fluid has ", of.size(), " particles and the skeleton ",
            body.size(), "; add both before");
    const double n_0 = body.material().coefficients.template get<PorousSkeletonParameters>().porosity;
    const auto& settings = scene.settings();
    const auto reach = [&](const auto& material) {
        return material.support_radius > 0 ? material.support_radius : settings.support_radius;
    };
    const double H = std::max(reach(of.material()), reach(body.material()));
    search::Periodic<dim> periodic;
    for (std::size_t d = 0; d < static_cast<std::size_t>(dim); ++d)
        periodic.length[d] = settings.periodic_length[d];
    search::NeighbourSearch<dim, double> neighbours(H, periodic, settings.threads);
    neighbours.add(of[position].template cast<double>());
    neighbours.add(body[position].template cast<double>());
    neighbours.update();
    const SupportRadius support(H);
    for (int i = 0; i < of.size(); ++i) {
        double share = 0;
        neighbours.for_each(0, i, 1, [&](int j, const auto&, double distance) {
            share += static_cast<double>(body[mass](j) / body[density](j)) *
                     Pair<dim, double>({}, distance, support, {}).value(Kernel{});
        });
        using Real = typename Scene::Real;
        const auto n = static_cast<Real>(1 - (1 - n_0) * share / std::max(share, detail::least_inner_sum));
        of[mass](i) *= n;
        of[density](i) *= n;
        of[porosity](i) = n;
    }
}

} // namespace imbibe
