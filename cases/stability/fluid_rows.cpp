// The fluids of the table.
#include "fluids.hpp"
#include "rows.hpp"

namespace stability {
namespace {

template <class F, class Real = double, int dim = 2>
void add(Table& table, const std::string& name) {
    const auto row = [&](const char* scene, auto run, double value = 0) {
        table.rows.push_back({"Fluids", name, scene, value, run});
    };
    row("shaken box", shaken_water<F, Real, dim>);
    row("still water", still_water<F, Real, dim>);
    row("impact at 0.05 c", impact<F, Real, dim>, 0.05);
    row("spinning square, clumps", spinning_square<F, Real, false, dim>);
    row("spinning square, voids", spinning_square<F, Real, true, dim>);
    row("splash", splash<F, Real, dim>);
    row("drops in flight", drops_in_flight<F, Real, dim>, 0.2);
    table.frontiers.push_back({name, "impact", "speed / c", 0.02, 1, impact<F, Real, dim>});
}

} // namespace

void add_fluids(Table& table) {
    add<WeaklyCompressible>(table, WeaklyCompressible::name);
    add<WeaklyCompressible, float>(table, sph::text(WeaklyCompressible::name, ", float"));
    add<Integrated<WeaklyCompressible, sph::StaggeredLeapfrog>>(
        table, sph::text(WeaklyCompressible::name, ", StaggeredLeapfrog"));
    add<Narrow>(table, Narrow::name);
    add<Unbraked>(table, Unbraked::name);
    add<DamBreak>(table, DamBreak::name);
    add<FloorlessDamBreak>(table, FloorlessDamBreak::name);
    add<UnbrakedDamBreak>(table, UnbrakedDamBreak::name);
    add<GuardedDamBreak>(table, GuardedDamBreak::name);
    add<Riemann>(table, Riemann::name);
    add<CorrectedGradients>(table, CorrectedGradients::name);
    add<Paper>(table, Paper::name);
    add<Integrated<Paper, sph::SymplecticEuler>>(table, sph::text(Paper::name, ", SymplecticEuler"));
    add<WeaklyCompressible, double, 3>(table, sph::text(WeaklyCompressible::name, ", 3D"));
    add<WeaklyCompressible, float, 3>(table, sph::text(WeaklyCompressible::name, ", 3D, float"));
    add<DamBreak, float, 3>(table, sph::text(DamBreak::name, ", 3D, float"));
    add<Riemann, float, 3>(table, sph::text(Riemann::name, ", 3D, float"));
    add<PaperInSpace, float, 3>(table, sph::text(Paper::name, ", 3D, float"));
}

} // namespace stability
