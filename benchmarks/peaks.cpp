// Measures what this machine can do at most, so that other results can be given as a fraction of it: multiply-adds in
// registers (counter `flops`, two per multiply-add) and the bandwidth of memory (counter `bytes`, for a = b + s c with
// three arrays far larger than the caches, each number counted once), on one thread and on two; and how long it waits
// for a single number from anywhere in so many MiB (counter `read`, in seconds). Run it:
//
//   build-benchmark/benchmarks/peaks
#include "support/measure.hpp"

#include <imbibe/core/memory.hpp>
#include <imbibe/core/pack_functions.hpp>

#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace imbibe;
using benchmark::Counter;

// Each sum waits for itself alone: as many of them as it takes to keep two units with a latency of four busy.
constexpr int sums = 12, rounds = 100'000;

template <class Real, int width>
void multiply_add(benchmark::State& state, int threads) {
    using T = Pack<Real, width>;
    for (auto _ : state) {
#ifdef _OPENMP
#pragma omp parallel num_threads(threads)
#endif
        {
            T x[sums], factor(0.999), summand(0.001);
            for (int k = 0; k < sums; ++k)
                x[k] = T(k);
            benchmark::DoNotOptimize(factor);
            benchmark::DoNotOptimize(summand);
            const T f = factor, s = summand;
            for (int r = 0; r < rounds; ++r)
                for (int k = 0; k < sums; ++k)
                    x[k] = x[k] * f + s;
            benchmark::DoNotOptimize(x);
        }
    }
    state.counters["flops"] = Counter(2.0 * sums * rounds * width * threads, Counter::kIsIterationInvariantRate);
    state.counters["width"] = width;
}

void triad(benchmark::State& state, int threads) {
    constexpr std::size_t n = 16 << 20; // 128 MiB an array
    static std::vector<double> a(n, 1), b(n, 2), c(n, 3);
    for (auto _ : state) {
#ifdef _OPENMP
#pragma omp parallel for num_threads(threads) schedule(static)
#endif
        for (std::size_t i = 0; i < n; ++i)
            a[i] = b[i] + 0.5 * c[i];
        benchmark::ClobberMemory();
    }
    state.counters["bytes"] = Counter(3.0 * sizeof(double) * n, Counter::kIsIterationInvariantRate);
    state.counters["threads"] = threads;
}

/// Reads numbers of which each says where the next one is, on another cache line, in memory as scenes have it.
void read(benchmark::State& state) {
    using Numbers = AlignedVector<std::uint32_t>;
    constexpr std::size_t in_line = 16;
    auto& next = bench::kept<Numbers>(state.range(0), [](std::int64_t mebibytes) {
        const std::size_t lines = (static_cast<std::size_t>(mebibytes) << 20) / sizeof(std::uint32_t) / in_line;
        Numbers made(lines * in_line);
        for (std::size_t k = 0; k < lines; ++k)
            made[k * in_line] = static_cast<std::uint32_t>(k * in_line);
        std::mt19937_64 random(1);
        for (std::size_t k = lines - 1; k > 0; --k) // Sattolo (1986): one cycle through all lines
            std::swap(made[k * in_line], made[random() % k * in_line]);
        return made;
    });
    constexpr int reads = 100'000;
    std::uint32_t at = 0;
    for (auto _ : state)
        for (int k = 0; k < reads; ++k) {
            at = next[at];
            benchmark::DoNotOptimize(at);
        }
    bench::per_item(state, "read", reads);
}

template <class Real>
void register_multiply_add() {
    constexpr int width = native_width<Real>;
    const std::string name = std::string("multiply_add/") + bench::real_name<Real> + "/" + std::to_string(width);
    benchmark::RegisterBenchmark((name + "/1_thread").c_str(), multiply_add<Real, width>, 1);
#ifdef _OPENMP
    benchmark::RegisterBenchmark((name + "/2_threads").c_str(), multiply_add<Real, width>, 2)->UseRealTime();
#endif
}

} // namespace

int main(int argc, char** argv) {
    register_multiply_add<float>();
    register_multiply_add<double>();
    benchmark::RegisterBenchmark("triad/1_thread", triad, 1);
#ifdef _OPENMP
    benchmark::RegisterBenchmark("triad/2_threads", triad, 2)->UseRealTime();
#endif
    benchmark::RegisterBenchmark("read", read)->RangeMultiplier(8)->Range(2, 1024);
    return bench::run_registered(argc, argv);
}
