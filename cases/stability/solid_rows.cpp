// The solids of the table.
#include "rows.hpp"
#include "solids.hpp"

namespace stability {
namespace {

template <class S, class Real = double>
void add(Table& table, const std::string& name) {
    const auto row = [&](const char* scene, auto run, double value) {
        table.rows.push_back({"Solids", name, scene, value, run});
    };
    row("shaken block, nu 0.3", shaken_solid<S, Real>, 0.3);
    row("stretched bar, 15 %", stretched_bar<S, Real>, 0.15);
    row("beam, nu 0.3", bent_beam<S, Real>, 0.3);
    row("beam, nu 0.499", bent_beam<S, Real>, 0.499);
    row("spinning plate", spinning_plate<S, Real>, 0);
    const auto poisson = [](double distance) { return 0.5 - distance; };
    table.frontiers.push_back({name, "beam", "Poisson's ratio", 0.2, 1e-4,
                               [](Plan plan) {
                                   plan.value = 0.5 - plan.value;
                                   return bent_beam<S, Real>(plan);
                               },
                               poisson});
    table.frontiers.push_back({name, "stretched bar", "stretch", 0.02, 0.6, stretched_bar<S, Real>});
}
template <class S, class Real = double>
void add_column(Table& table, const std::string& name) {
    table.rows.push_back({"Solids", name, "3D column, nu 0.45", 0.45, twisted_column<S, Real>});
    table.rows.push_back({"Solids", name, "3D column, nu 0.499", 0.499, twisted_column<S, Real>});
}

} // namespace

void add_solids(Table& table) {
    add<Hookean>(table, Hookean::name);
    add_column<Hookean>(table, Hookean::name);
    add<Hookean, float>(table, sph::text(Hookean::name, ", float"));
    add_column<Hookean, float>(table, sph::text(Hookean::name, ", float"));
    add<Kirchhoff>(table, Kirchhoff::name);
    add_column<Kirchhoff>(table, Kirchhoff::name);
    add<Averaged>(table, Averaged::name);
    add_column<Averaged>(table, Averaged::name);
    add<Hypoelastic>(table, Hypoelastic::name);
    add_column<Hypoelastic>(table, Hypoelastic::name);
    table.rows.push_back({"Solids", Hypoelastic::name, "colliding rings", 0.059, colliding_rings<Hypoelastic>});
    table.frontiers.push_back(
        {Hypoelastic::name, "colliding rings", "speed / c", 0.01, 0.3, colliding_rings<Hypoelastic>});
}

} // namespace stability
