// The rows of the table that are about single particles: thin walls and sheets, slots, starts, two fluids, projectiles,
// pairs.
#include "crowd.hpp"
#include "rows.hpp"
#include "starts.hpp"
#include "thin.hpp"
#include "two_fluids.hpp"

#include <cstdio>

namespace stability {
namespace {

template <class F>
void add_walls(Table& table) {
    const auto row = [&](const char* scene, auto run) { table.rows.push_back({"Hard", F::name, scene, 1, run}); };
    row("wall of one layer, 1 m", thin_wall<F, 1>);
    row("wall of two layers, 1 m", thin_wall<F, 2>);
    row("wall of three layers, 1 m", thin_wall<F, 3>);
    table.frontiers.push_back({F::name, "wall of one layer", "metres of water", 0.1, 20, thin_wall<F, 1>});
    table.frontiers.push_back({F::name, "wall of two layers", "metres of water", 1, 20, thin_wall<F, 2>});
}
template <class F>
void add_pairs(Table& table) {
    table.frontiers.push_back({F::name, "columns in pairs", "spacings apart", 0.9, 0.01, columns_in_pairs<F>});
}
template <class C>
void add_overlap(Table& table) {
    table.frontiers.push_back({C::name, "water in an elastic block", "spacings deep", 0.1, 4, water_in_solid<C>});
}

} // namespace

void add_hard(Table& table) {
    add_walls<WeaklyCompressible>(table);
    add_walls<Unguarded>(table);
    add_walls<Riemann>(table);
    add_walls<Paper>(table);
    table.rows.push_back(
        {"Hard", WeaklyCompressible::name, "drop along a wall", 0.01, drop_along_wall<WeaklyCompressible>});
    table.rows.push_back({"Hard", DamBreak::name, "drop along a wall", 0.01, drop_along_wall<DamBreak>});
    table.rows.push_back({"Hard", Riemann::name, "drop along a wall", 0.01, drop_along_wall<Riemann>});
    table.rows.push_back({"Hard", Paper::name, "drop along a wall", 0.01, drop_along_wall<Paper>});
    table.rows.push_back({"Hard", Hookean::name, "rough sheet and thread", 0.2, thin_solids<Hookean>});
    table.rows.push_back({"Hard", "AntuonoDiffusion", "rough thread, drops", 0.3, thin_water});
    table.rows.push_back({"Hard", "two fluids", "layers, 1000 to 1", 1000, layers});
    table.rows.push_back({"Hard", "WendlandC2", "fifty neighbours", 0, crowded<sph::WendlandC2>});
    table.rows.push_back({"Hard", "CubicSpline", "fifty neighbours", 0, crowded<sph::CubicSpline>});

    table.frontiers.push_back(
        {Hookean::name, "sheet and thread", "roughness, spacings", 0.02, 0.45, thin_solids<Hookean>});
    table.frontiers.push_back({"AntuonoDiffusion", "thread, drops", "roughness, spacings", 0.02, 0.45, thin_water});
    table.frontiers.push_back(
        {WeaklyCompressible::name, "floor with slots", "width, spacings", 0.1, 4, slotted_floor<WeaklyCompressible>});
    table.frontiers.push_back({Riemann::name, "floor with slots", "width, spacings", 0.1, 4, slotted_floor<Riemann>});
    table.frontiers.push_back({Paper::name, "floor with slots", "width, spacings", 0.1, 4, slotted_floor<Paper>});
    add_pairs<WeaklyCompressible>(table);
    add_pairs<Narrow>(table);
    add_pairs<Riemann>(table);
    add_pairs<Paper>(table);
    add_overlap<SoundCoupling>(table);
    add_overlap<PaperCoupling>(table);
    table.frontiers.push_back({"two fluids", "layers", "ratio of densities", 1, 1000, layers});
    table.frontiers.push_back({"neighbours that serve 1000 steps", "swarm", "supports a step", 0.001, 10,
                               [](const Plan& plan) { return fast_swarm<90>(plan); }});
}

void write_gradients(std::ostream& out) {
    out << "\n## Gradient of x inside a lattice\n\n| support, spacings | WendlandC2, 2D | 3D | CubicSpline, 2D | 3D | "
           "Spiky, 2D | 3D |\n|---|---|---|---|---|---|---|\n";
    for (const double support : {1.1, 1.25, 1.3, 1.5, 1.75, 2.0, 2.6, 3.0}) {
        out << "| " << support;
        for (const double gradient :
             {gradient_of_x<sph::WendlandC2, 2>(support), gradient_of_x<sph::WendlandC2, 3>(support),
              gradient_of_x<sph::CubicSpline, 2>(support), gradient_of_x<sph::CubicSpline, 3>(support),
              gradient_of_x<sph::Spiky, 2>(support), gradient_of_x<sph::Spiky, 3>(support)}) {
            char words[32];
            std::snprintf(words, sizeof words, "%.2f", gradient);
            out << " | " << words;
        }
        out << " |\n";
    }
}

} // namespace stability
