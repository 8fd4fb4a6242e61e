// Measures the fluid of the benchmarks with packs of different widths. The width follows from the instruction set the
// compiler may use, so this file is compiled once for each: bench_widths_sse2, bench_widths_avx2 and, on a machine that
// has it, bench_widths_avx512. About 100,000 particles, support of 2.6 spacings, one thread. Counter `particle` is the
// time per particle of: `search`, order and runs; `loops`, a step without the search and the motion; `step`, all. Run:
//
//   build-benchmark/benchmarks/bench_widths_avx2
#include "support/block.hpp"
#include "support/fluid.hpp"
#include "support/measure.hpp"

#include <string>

namespace {

using namespace imbibe;
using bench::Water;

constexpr int particles = 100'000;

template <class Real, class Work>
void measure(benchmark::State& state, const Work& work) {
    auto& engine = bench::kept<bench::Block<Real, Water>>(
        0, [](int) { return bench::block<Real>(bench::water<Water>(), particles, 2.6); });
    for (auto _ : state)
        work(engine);
    bench::per_item(state, "particle", engine.template state<Water>().size());
    state.counters["width"] = native_width<Real>;
}

template <class Real>
void add_all() {
    const auto add = [](const std::string& name, auto work) {
        benchmark::RegisterBenchmark(
            (name + "/" + bench::real_name<Real> + "/" + std::to_string(native_width<Real>)).c_str(),
            [work](benchmark::State& state) { measure<Real>(state, work); });
    };
    add("search", [](auto& engine) { engine.find_neighbours(); });
    add("loops", [](auto& engine) { bench::run_loops(engine); });
    add("step", [](auto& engine) { SymplecticEuler::step(engine, 1e-9); });
}

} // namespace

int main(int argc, char** argv) {
    add_all<float>();
    add_all<double>();
    return bench::run_registered(argc, argv);
}
