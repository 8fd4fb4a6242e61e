// Loops over blocks of particles, with threads if OpenMP is switched on. Blocks are independent, so no result depends
// on the number of threads. Every loop of many blocks gives a thread about the same share of the particles first, so
// that its data are still near the core that reads them in the next loop.
#pragma once

#include <imbibe/core/build_options.hpp>
#include <imbibe/core/denormals.hpp>

#include <exception>

#ifdef _OPENMP
#include <atomic>
#include <omp.h>
#include <vector>
#endif

namespace imbibe {

#ifdef _OPENMP
namespace detail {

/// Deals out 0 ... n-1 to the threads of a team: each works through its own stretch in order, then takes what the
/// others have not begun of theirs.
///
/// Source: Markatos and LeBlanc (1992), affinity scheduling; here the stretch is taken one by one.
class Shares {
public:
    Shares(int n, int threads) : shares(static_cast<std::size_t>(threads)) {
        for (int k = 0; k < threads; ++k) {
            const auto begin = [&](long long share) { return static_cast<int>(n * share / threads); };
            shares[static_cast<std::size_t>(k)].next = begin(k);
            shares[static_cast<std::size_t>(k)].end = begin(k + 1);
        }
    }
    /// Calls f(k) for every k that thread `own` gets.
    template <class F>
    void work(std::size_t own, const F& f) {
        for (std::size_t turn = 0; turn < shares.size(); ++turn) {
            Share& share = shares[(own + turn) % shares.size()];
            if (share.next.load(std::memory_order_relaxed) >= share.end)
                continue; // saves a write to the other thread's cache line
            for (int k; (k = share.next.fetch_add(1, std::memory_order_relaxed)) < share.end;)
                f(k);
        }
    }

private:
    struct alignas(64) Share { // a cache line each
        std::atomic<int> next;
        int end;
    };
    std::vector<Share> shares;
};

} // namespace detail
#endif

/// The most threads that a scene or a search takes: on a machine that cannot create that many, OpenMP would end the
/// program without a message.
inline constexpr int most_threads = 1024;

/// How many threads a loop may use at most: the machine's, or 1 without OpenMP.
IMBIBE_PER_BUILD inline int available_threads() {
#ifdef _OPENMP
    const int threads = omp_get_max_threads();
    return threads < most_threads ? threads : most_threads;
#else
    return 1;
#endif
}

/// Calls f(k) for k = 0 ... n-1 in any order, on up to `threads` threads that begin at even distances. f must not write
/// what another call reads. The first exception thrown by a call is rethrown; with several threads, after all are done.
/// f runs with denormal numbers taken as zero. Not inlined, so that a profile tells what threads share and what they do
/// not (tools/serial_share.py).
template <class F>
[[gnu::noinline]] IMBIBE_PER_BUILD void parallel_for(int n, [[maybe_unused]] int threads, const F& f) {
#ifdef _OPENMP
    if (threads > 1 && n > 1) {
        std::exception_ptr failure;
        // If fewer threads start, they do the work of the missing ones. With more shares than blocks, the first thread,
        // which is awake already, would have none.
        detail::Shares shares(n, n < threads ? n : threads);
#pragma omp parallel num_threads(threads)
        {
            const DenormalsAreZero fast;
            shares.work(static_cast<std::size_t>(omp_get_thread_num()), [&](int k) {
                try {
                    f(k);
                } catch (...) {
#pragma omp critical(imbibe_parallel_for)
                    if (!failure)
                        failure = std::current_exception();
                }
            });
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
    parallel_for(n / block + (n % block != 0), threads, [&](int k) {
        const int begin = k * block;
        f(begin, n - begin > block ? begin + block : n);
    });
}

/// combine(result, map(begin, end)) over fixed blocks in fixed order: the same bits for any number of threads.
template <class T, class Map, class Combine>
IMBIBE_PER_BUILD T parallel_reduce(int n, int threads, T start, const Map& map, const Combine& combine) {
    constexpr int block = 4096, most = 512;
    const int size = n / most + 1 > block ? n / most + 1 : block;
    T parts[most + 1];
    const int blocks = n / size + (n % size != 0);
    parallel_for(blocks, threads, [&](int k) {
        const int begin = k * size;
        parts[k] = map(begin, n - begin > size ? begin + size : n);
    });
    for (int k = 0; k < blocks; ++k)
        start = combine(start, parts[k]);
    return start;
}

} // namespace imbibe
