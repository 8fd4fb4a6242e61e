// Measures the loops of a step without the search and the motion, on one thread: for a fluid and for a hypoelastic
// solid against the same loops written by hand (support/hand_fluid.hpp, hand_solid.hpp), in turns, so that other work
// on the machine meets both; and for a total-Lagrangian solid. About 100,000 particles; the last number of a name is
// the support in tenths of the spacing. Counters: `particle`, the time per particle; `hand`, that of the loop by hand;
// `ratio`, generic over hand, both the least of all turns; `operations`, floating point operations a particle that the
// lanes of the loop by hand do. Run it:
//
//   build-benchmark/benchmarks/bench_sweep
#include "support/block.hpp"
#include "support/fluid.hpp"
#include "support/hand_fluid.hpp"
#include "support/hand_solid.hpp"
#include "support/measure.hpp"

#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/solid/total_lagrangian.hpp>

#include <string>

namespace {

using namespace imbibe;
using bench::Block;
using bench::Hypoelastic;
using bench::Water;
using bench::WaterInOneSweep;
using K = WendlandC2;

struct TotalLagrangian : Solid<TotalLagrangianSolid<StVenantKirchhoff, K>, TotalLagrangianViscosity<K>> {};

constexpr int particles = 100'000;

template <class Real, class Phase>
Block<Real, Phase>& kept_block(const benchmark::State& state, const Phase& phase) {
    return bench::kept<Block<Real, Phase>>(state.range(0), [&](std::int64_t tenths) {
        return bench::block<Real>(phase, particles, 0.1 * static_cast<double>(tenths));
    });
}

/// How far the accelerations of the loop by hand are from the library's, relative to the greatest.
template <class Real, class Phase>
double difference(const auto& hand, const Block<Real, Phase>& engine) {
    const auto& s = engine.template state<Phase>();
    double greatest = 0, apart = 0;
    for (std::size_t d = 0; d < 3; ++d)
        for (std::size_t i = 0; i < static_cast<std::size_t>(s.size()); ++i) {
            const double a = static_cast<double>((s.field(acceleration) + d * s.stride())[i]);
            greatest = std::max(greatest, std::abs(a));
            apart = std::max(apart, std::abs(a - static_cast<double>(hand.acceleration[d][i])));
        }
    return apart / greatest;
}

// Runs the library's loops and those by hand in turns.
template <class Real, class Phase, class Hand>
void in_turns(benchmark::State& state, Block<Real, Phase>& engine, Hand& hand, void (*loops_by_hand)(Hand&)) {
    const auto n = static_cast<double>(engine.template state<Phase>().size());
    double generic_least = 1e30, hand_least = 1e30;
    for (auto _ : state) {
        const double generic_time = bench::seconds_of([&] { bench::run_loops(engine); });
        const double hand_time = bench::seconds_of([&] { loops_by_hand(hand); });
        state.SetIterationTime(generic_time);
        generic_least = std::min(generic_least, generic_time);
        hand_least = std::min(hand_least, hand_time);
    }
    if (!(difference<Real, Phase>(hand, engine) < 1e-3))
        state.SkipWithError("the loop by hand computes something else than the library");
    state.counters["particle"] = generic_least / n;
    state.counters["hand"] = hand_least / n;
    state.counters["ratio"] = generic_least / hand_least;
    state.counters["runs"] = bench::runs_per_particle(engine.template link<Phase, Phase, false>().runs);
    state.counters["neighbours"] = bench::neighbours_in(engine);
    state.counters["width"] = Hand::width;
}

template <class Real, class Phase>
void fluid(benchmark::State& state) {
    auto& engine = kept_block<Real>(state, bench::water<Phase>());
    using Hand = bench::HandFluid<Real>;
    Hand hand(std::type_identity<Phase>{}, engine);
    in_turns<Real, Phase, Hand>(state, engine, hand, [](Hand& h) {
        if constexpr (std::is_same_v<Phase, WaterInOneSweep>)
            h.one_sweep();
        else
            h.two_sweeps(0);
    });
    state.counters["operations"] =
        static_cast<double>(state.counters["runs"]) * Hand::width * Hand::operations_per_neighbour;
}

template <class Real>
void hypoelastic(benchmark::State& state) {
    auto& engine = kept_block<Real>(state, bench::rubber<Hypoelastic>());
    using Hand = bench::HandSolid<Real>;
    Hand hand(engine);
    in_turns<Real, Hypoelastic, Hand>(state, engine, hand, [](Hand& h) { h.two_sweeps(0); });
}

template <class Real>
void total_lagrangian(benchmark::State& state) {
    auto& engine = kept_block<Real>(state, bench::rubber<TotalLagrangian>());
    for (auto _ : state)
        bench::run_loops(engine);
    bench::per_item(state, "particle", engine.template state<TotalLagrangian>().size());
    state.counters["neighbours"] = bench::neighbours_in(engine);
}

template <class Real>
void add_all() {
    const std::string real = bench::real_name<Real>;
    const auto add = [&](const char* name, void (*f)(benchmark::State&), const std::vector<std::int64_t>& supports) {
        return benchmark::RegisterBenchmark((name + ("/" + real)).c_str(), f)->ArgsProduct({supports});
    };
    add("fluid/one_sweep", fluid<Real, WaterInOneSweep>, {20, 26, 35})->UseManualTime();
    add("fluid/two_sweeps", fluid<Real, Water>, {20, 26, 35})->UseManualTime();
    add("hypoelastic", hypoelastic<Real>, {20, 26})->UseManualTime();
    add("total_lagrangian", total_lagrangian<Real>, {20, 26});
}

} // namespace

int main(int argc, char** argv) {
    add_all<float>();
    add_all<double>();
    return bench::run_registered(argc, argv);
}
