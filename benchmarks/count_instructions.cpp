// A fixed piece of work, for counting instructions: unlike times, their number does not depend on what else the machine
// does. `measured` is called once with the work; all around it is preparation. The program prints over how many
// particles, or evaluations, the count is to be divided. Compiled for the same instruction set everywhere (valgrind has
// no AVX-512). tools/count_instructions.py runs all cases:
//
//   python3 tools/count_instructions.py build-benchmark/benchmarks/count_instructions -o counts.json
//   build-benchmark/benchmarks/count_instructions            the names of the cases
//   valgrind --tool=callgrind --toggle-collect=measured build-benchmark/benchmarks/count_instructions fluid_step_float
#include "support/block.hpp"
#include "support/dam_break.hpp"
#include "support/fluid.hpp"
#include "support/hand_fluid.hpp"
#include "support/hand_solid.hpp"
#include "support/measured.hpp"

#include <imbibe/kernels/kernels.hpp>
#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/solid/total_lagrangian.hpp>

#include <cstring>
#include <map>
#include <string>

namespace {

using namespace imbibe;
using bench::count;
using bench::DamBreak;
using bench::Water;
using K = WendlandC2;

struct Rubber : Solid<TotalLagrangianSolid<StVenantKirchhoff, K>, TotalLagrangianViscosity<K>> {};

constexpr int particles = 8000;
constexpr double support = 2.6;
constexpr double more = 3.2; // than that

/// W and the factor of its gradient, of every kernel, in whole packs.
template <class Real, class... Kernel>
double kernels() {
    constexpr int width = native_width<Real>, n = 1024;
    using T = Pack<Real, width>;
    std::vector<Real> r(n), w(n, Real(0));
    for (std::size_t k = 0; k < n; ++k)
        r[k] = static_cast<Real>(1.05e-2 * static_cast<double>(k) / n);
    Pair<3, T> ab{};
    ab.set(SupportRadius(1e-2));
    const auto add = [&](std::size_t k, auto kernel) {
        ab.distance = T::load(r.data() + k);
        const T all = T::load(w.data() + k) + ab.value(kernel) + ab.gradient(kernel);
        std::memcpy(w.data() + k, &all, sizeof(T));
    };
    count([&] {
        (
            [&] {
                for (std::size_t k = 0; k < n; k += width)
                    add(k, Kernel{});
            }(),
            ...);
    });
    return n * sizeof...(Kernel);
}

/// The runs of all particles.
template <class Real>
double search() {
    bench::Cloud<Real> cloud(particles, support * bench::spacing, bench::Order::sorted);
    search::RunList runs;
    const auto find = [&] {
        cloud.find_order();
        search::find_runs<native_width<Real>>(runs, cloud.points(), cloud.points(), cloud.grid, cloud.table,
                                              cloud.support, 1);
    };
    find(); // makes room
    count(find);
    return cloud.count;
}

/// The loops of a step without the search and the motion.
template <class Real, class Phase>
double loops(const Phase& phase, double reach = support) {
    auto engine = bench::block<Real>(phase, particles, reach);
    count([&] { bench::run_loops(engine); });
    return engine.template state<Phase>().size();
}

/// The same for the fluid, written by hand.
template <class Real, class Phase>
double fluid_by_hand(double reach = support) {
    auto engine = bench::block<Real>(bench::water<Phase>(), particles, reach);
    bench::HandFluid<Real> hand(std::type_identity<Phase>{}, engine);
    if constexpr (std::is_same_v<Phase, Water>)
        count([&] { hand.two_sweeps(0); });
    else
        count([&] { hand.one_sweep(); });
    return engine.template state<Phase>().size();
}

/// The same for the hypoelastic solid, written by hand.
template <class Real>
double solid_by_hand() {
    auto engine = bench::block<Real>(bench::rubber<bench::Hypoelastic>(), particles, support);
    bench::HandSolid<Real> hand(engine);
    count([&] { hand.two_sweeps(0); });
    return engine.template state<bench::Hypoelastic>().size();
}

/// A whole step.
template <class Real, class Phase>
double step(const Phase& phase) {
    auto engine = bench::block<Real>(phase, particles, support);
    SymplecticEuler::step(engine, 1e-6);
    count([&] { SymplecticEuler::step(engine, 1e-6); });
    return engine.template state<Phase>().size();
}

/// Whole steps of the dam break, of which one in four searches.
template <class Real>
double dam_break() {
    auto scene = DamBreak<Real, 4>::make(particles, 1);
    constexpr int steps = 4;
    for (int k = 0; k < steps; ++k)
        scene.step();
    count([&] {
        for (int k = 0; k < steps; ++k)
            scene.step();
    });
    double working = 0;
    scene.engine().for_each_phase([&]<class P>(std::type_identity<P>, const auto& phase) {
        working += bench::working<P>(scene.engine(), phase.size());
    });
    return steps * working;
}

template <class Real>
void add(std::map<std::string, double (*)()>& cases, const std::string& real) {
    cases["kernels_" + real] =
        kernels<Real, CubicSpline, QuinticSpline, WendlandC2, WendlandC4, WendlandC6, Poly6, Spiky>;
    cases["search_" + real] = search<Real>;
    cases["fluid_loops_" + real] = [] { return loops<Real>(bench::water<Water>()); };
    cases["fluid_loops_in_one_sweep_" + real] = [] { return loops<Real>(bench::water<bench::WaterInOneSweep>()); };
    cases["fluid_loops_by_hand_" + real] = [] { return fluid_by_hand<Real, Water>(); };
    cases["fluid_loops_in_one_sweep_by_hand_" + real] = [] { return fluid_by_hand<Real, bench::WaterInOneSweep>(); };
    // With more neighbours: the difference is what the loops take for a pair, without the beginning and end of a sum.
    cases["fluid_loops_of_more_" + real] = [] { return loops<Real>(bench::water<Water>(), more); };
    cases["fluid_loops_of_more_by_hand_" + real] = [] { return fluid_by_hand<Real, Water>(more); };
    cases["hypoelastic_loops_" + real] = [] { return loops<Real>(bench::rubber<bench::Hypoelastic>()); };
    cases["hypoelastic_loops_by_hand_" + real] = solid_by_hand<Real>;
    cases["fluid_step_" + real] = [] { return step<Real>(bench::water<Water>()); };
    cases["dam_break_step_" + real] = dam_break<Real>;
    cases["solid_step_" + real] = [] { return step<Real>(bench::rubber<Rubber>()); };
}

} // namespace

int main(int argc, char** argv) {
    std::map<std::string, double (*)()> cases;
    add<float>(cases, "float");
    add<double>(cases, "double");
    if (argc == 2 && cases.contains(argv[1])) {
        std::printf("items %.0f\n", cases[argv[1]]());
        return 0;
    }
    for (const auto& [name, work] : cases)
        std::printf("case %s\n", name.c_str());
    bench::print_compiler();
    return argc == 1 ? 0 : 2;
}
