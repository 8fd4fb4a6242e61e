// What programs whose instructions are counted by callgrind have in common, beside times without Google Benchmark.
#pragma once

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>

#ifdef __clang__
#define BENCH_AS_WRITTEN __attribute__((noinline))
#else
#define BENCH_AS_WRITTEN __attribute__((noipa)) // nor a copy of it under another name
#endif

// Called once with the work; all around it is preparation. By its C name callgrind finds it, whatever the compiler.
extern "C" BENCH_AS_WRITTEN inline void measured(const std::function<void()>* work) {
    (*work)();
    __asm__ volatile("" ::: "memory"); // no tail call: callgrind is to see where it ends
}

namespace imbibe::bench {

/// Does the work that is counted.
inline void count(const std::function<void()>& work) {
    measured(&work);
}

/// CPU seconds of the shortest of so many calls of f: other programs on the machine do not count.
template <class F>
double shortest_seconds(int calls, const F& f) {
    const auto now = [] {
        std::timespec t{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
        return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
    };
    double shortest = 1e9;
    for (int k = 0; k < calls; ++k) {
        const double begin = now();
        f();
        shortest = std::min(shortest, now() - begin);
    }
    return shortest;
}

/// With which compiler counts are to be compared.
inline void print_compiler() {
#ifdef __clang__
    std::printf("compiler clang++ %s\n", __clang_version__);
#else
    std::printf("compiler g++ %s\n", __VERSION__);
#endif
}

} // namespace imbibe::bench
