// The coupled scenes of the table.
#include "coupled.hpp"
#include "frames.hpp"
#include "rows.hpp"

#include <cstdio>

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
    if constexpr (dim == 2)
        row("free fall", free_fall<C, Real>, 0);
    table.frontiers.push_back(
        {name, "block on a pool", "density / that of water", 1, 0.002, block_on_pool<C, Real, dim>});
    table.frontiers.push_back(
        {name, "heavy block on a pool", "density / that of water", 1, 20, block_on_pool<C, Real, dim>});
    table.frontiers.push_back({name, "water on a plate", "speed / c", 0.01, 0.5, [](Plan plan) {
                                   plan.value *= 30; // m/s
                                   return water_on_plate<C, Real, dim>(plan);
                               }});
}

template <class C>
void add_frames(std::ostream& out) {
    const auto off = [&](double difference) {
        char words[32];
        std::snprintf(words, sizeof words, "%.1g", difference);
        out << " | " << words;
    };
    out << "| " << C::name;
    const auto home = meet<double, C>({});
    for (const NamedFrame& it : frames())
        off(difference(meet<double, C>(it.frame), home));
    const auto home_in_float = meet<float, C>({});
    const Eigen::RowVector2d away(far_away, -far_away);
    off(difference(meet<float, C>({.offset = away, .origin = {far_away, -far_away}}), home_in_float));
    off(difference(meet<float, C>({.offset = away}), home_in_float));
    out << " |\n";
}

} // namespace

void write_frames(std::ostream& out) {
    out << "\n## An impact seen from other frames\n\n"
           "The greatest difference of any particle from the same impact at home: of places in spacings, of "
           "velocities\n"
           "in m/s (the impact has 1 m/s); in double, but for the last two columns, in float and ten thousand heights\n"
           "of the scene away.\n\n| composition |";
    for (const NamedFrame& it : frames())
        out << ' ' << it.name << " |";
    out << " far away, with `Settings::origin` | without |\n|---|";
    for (std::size_t k = 0; k < frames().size() + 2; ++k)
        out << "---|";
    out << '\n';
    add_frames<SoundCoupling>(out);
    add_frames<RiemannCoupling>(out);
    add_frames<PaperCoupling>(out);
}

void add_coupled(Table& table) {
    add<SoundCoupling>(table, SoundCoupling::name);
    add<SoundCoupling, float>(table, sph::text(SoundCoupling::name, ", float"));
    add<CoupledWith<SoundCoupling, sph::StaggeredLeapfrog>>(table,
                                                            sph::text(SoundCoupling::name, ", StaggeredLeapfrog"));
    add<RiemannCoupling>(table, RiemannCoupling::name);
    add<PaperCoupling>(table, PaperCoupling::name);
    add<SoundCoupling, float, 3>(table, sph::text(SoundCoupling::name, ", 3D, float"));
    add<SoundCouplingFiner>(table, SoundCouplingFiner::name);
    add<SoundCouplingAsOffered, float, 3>(table, sph::text(SoundCouplingAsOffered::name, ", 3D, float"));
    add<PaperCouplingInSpace, float, 3>(table, sph::text(PaperCoupling::name, ", 3D, float"));
}

} // namespace stability
