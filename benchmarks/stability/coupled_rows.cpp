// The coupled scenes of the table.
#include "coupled.hpp"
#include "rows.hpp"

namespace stability {
namespace {

template <class C, class Real = double, int dim = 2>
void add(Table& table, const std::string& name) {
    const auto row = [&](const char* scene, auto run, double value) {
        table.rows.push_back({"Coupled", name, scene, value, run});
    };
    row("water on a plate, 1 m/s", water_on_plate<C, Real, dim>, 1);
    row("block as heavy as water", block_on_pool<C, Real, dim>, 1);
    row("block of a tenth", block_on_pool<C, Real, dim>, 0.1);
    row("block ten times as heavy", block_on_pool<C, Real, dim>, 10);
    table.frontiers.push_back(
        {name, "block on a pool", "density / that of water", 1, 0.002, block_on_pool<C, Real, dim>});
    table.frontiers.push_back(
        {name, "heavy block on a pool", "density / that of water", 1, 20, block_on_pool<C, Real, dim>});
    table.frontiers.push_back({name, "water on a plate", "speed / c", 0.01, 0.5, [](Plan plan) {
                                   plan.value *= 30; // m/s
                                   return water_on_plate<C, Real, dim>(plan);
                               }});
}

} // namespace

void add_coupled(Table& table) {
    add<SoundCoupling>(table, SoundCoupling::name);
    add<SoundCoupling, float>(table, sph::text(SoundCoupling::name, ", float"));
    add<CoupledWith<SoundCoupling, sph::StaggeredLeapfrog>>(table,
                                                            sph::text(SoundCoupling::name, ", StaggeredLeapfrog"));
    add<RiemannCoupling>(table, RiemannCoupling::name);
    add<PaperCoupling>(table, PaperCoupling::name);
    add<SoundCoupling, float, 3>(table, sph::text(SoundCoupling::name, ", 3D, float"));
    add<PaperCouplingInSpace, float, 3>(table, sph::text(PaperCoupling::name, ", 3D, float"));
}

} // namespace stability
