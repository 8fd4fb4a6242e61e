// What the benchmarks have in common: how they count, and how they keep a prepared scene from one call to the next.
#pragma once

#include <benchmark/benchmark.h>

#include <ctime>
#include <map>
#include <memory>
#include <utility>

namespace imbibe::bench {

/// Reports the time per item of an iteration that handles `items` of them, in seconds, as counter `name`.
inline void per_item(benchmark::State& state, const char* name, double items) {
    using benchmark::Counter;
    state.counters[name] = Counter(items, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

/// The value of make(key), made when it is first asked for. Google Benchmark calls a function several times to find out
/// how many iterations it needs, and a scene of a million particles takes longer to make than to measure. Only the
/// value of the last key is kept, so that large scenes do not pile up.
template <class Value, class Key, class Make>
Value& kept(const Key& key, const Make& make) {
    static std::map<Key, std::unique_ptr<Value>> last;
    if (!last.contains(key)) {
        last.clear();
        last[key] = std::make_unique<Value>(make(key));
    }
    return *last[key];
}

/// CPU seconds of this thread: other programs on the machine do not count.
inline double cpu_seconds() {
    std::timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// CPU seconds of one call of f.
template <class F>
double seconds_of(const F& f) {
    const double begin = cpu_seconds();
    f();
    return cpu_seconds() - begin;
}

/// What BENCHMARK_MAIN does, for programs that register their benchmarks by themselves. Returns the exit status.
inline int run_registered(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 1;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}

/// "float" or "double".
template <class Real>
constexpr const char* real_name = sizeof(Real) == 4 ? "float" : "double";

} // namespace imbibe::bench
