// Loops over blocks of particles, with threads where OpenMP is switched on. Blocks are independent, so nothing that
// is computed depends on how many threads there are.
#pragma once

#include <imbibe/core/build_options.hpp>
#include <imbibe/core/denormals.hpp>

#include <exception>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace imbibe {

/// How many threads a loop may use at most: the machine's, or 1 without OpenMP.
IMBIBE_PER_BUILD inline int available_threads() {
#ifdef _OPENMP
    return omp_get_max_threads();
#else
    return 1;
#endif
}

/// The threads for a loop that does next to nothing per particle: below some thousand particles, waking the others
/// takes longer than the loop.
inline int threads_for(int particles, int threads) {
    return particles < 4096 ? 1 : threads;
}

/// Calls f(k) for k = 0 ... n-1, on up to `threads` threads in any order. f must not write what another call reads.
/// The first exception thrown by a call is thrown again when all are done. In f denormal numbers are zero.
template <class F>
IMBIBE_PER_BUILD void parallel_for(int n, [[maybe_unused]] int threads, const F& f) {
#ifdef _OPENMP
    if (threads > 1 && n > 1) {
        std::exception_ptr failure;
#pragma omp parallel num_threads(threads)
        {
            const DenormalsAreZero fast;
#pragma omp for schedule(dynamic, 1)
            for (int k = 0; k < n; ++k) {
                try {
                    f(k);
                } catch (...) {
#pragma omp critical(imbibe_parallel_for)
                    if (!failure)
                        failure = std::current_exception();
                }
            }
        }
        if (failure)
            std::rethrow_exception(failure);
        return;
    }
#endif
    const DenormalsAreZero fast;
    for (int k = 0; k < n; ++k)
        f(k);
}

/// Splits n particles into blocks of `block` and calls f(begin, end) for each.
template <class F>
IMBIBE_PER_BUILD void parallel_blocks(int n, int block, int threads, const F& f) {
    parallel_for((n + block - 1) / block, threads, [&](int k) {
        const int begin = k * block;
        f(begin, begin + block < n ? begin + block : n);
    });
}

/// combine(result, map(begin, end)) over fixed blocks in fixed order: the same bits for any number of threads.
template <class T, class Map, class Combine>
IMBIBE_PER_BUILD T parallel_reduce(int n, int threads, T start, const Map& map, const Combine& combine) {
    constexpr int block = 4096, most = 512;
    const int size = n / most + 1 > block ? n / most + 1 : block;
    T parts[most + 1];
    const int blocks = (n + size - 1) / size;
    parallel_for(blocks, threads, [&](int k) {
        const int begin = k * size;
        parts[k] = map(begin, begin + size < n ? begin + size : n);
    });
    for (int k = 0; k < blocks; ++k)
        start = combine(start, parts[k]);
    return start;
}

} // namespace imbibe
