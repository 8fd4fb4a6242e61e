// Loops over blocks: each block once, whoever takes it, and no exception lost.
#include <catch_shim.hpp>

#include <imbibe/core/parallel.hpp>

#include <numeric>
#include <stdexcept>
#include <vector>

namespace {

using imbibe::parallel_blocks;
using imbibe::parallel_for;

// How often each k was called; ints of their own, so that no two threads write one.
std::vector<int> calls(int n, int threads) {
    std::vector<int> counts(static_cast<std::size_t>(n), 0);
    parallel_for(n, threads, [&](int k) { ++counts[static_cast<std::size_t>(k)]; });
    return counts;
}

} // namespace

TEST_CASE("every block is called once, with fewer and with more threads than blocks") {
    for (const int n : {0, 1, 2, 3, 7, 1000})
        for (const int threads : {1, 2, 3, 4}) {
            CAPTURE(n, threads);
            CHECK(calls(n, threads) == std::vector<int>(static_cast<std::size_t>(n), 1));
        }
}
TEST_CASE("blocks follow each other without a gap, the last is what is left") {
    for (const int n : {0, 1, 255, 256, 257, 5000}) {
        std::vector<int> seen(static_cast<std::size_t>(n), 0);
        parallel_blocks(n, 256, 3, [&](int begin, int end) {
            for (int i = begin; i < end; ++i)
                ++seen[static_cast<std::size_t>(i)];
        });
        CHECK(seen == std::vector<int>(static_cast<std::size_t>(n), 1));
    }
}
TEST_CASE("particles near the greatest number there can be are split without overflow") {
    const int n = 2147483647;
    const auto sum = imbibe::parallel_reduce(
        n, 2, 0LL, [](int begin, int end) { return static_cast<long long>(end) - begin; },
        [](long long a, long long b) { return a + b; });
    CHECK(sum == n);
}
TEST_CASE("an exception in one block is thrown again, and with threads the others are done") {
#ifdef _OPENMP
    constexpr int others = 99;
#else
    constexpr int others = 37;
#endif
    for (const int threads : {2, 4}) {
        std::vector<int> done(100, 0);
        CHECK_THROWS_AS(parallel_for(100, threads,
                                     [&](int k) {
                                         if (k == 37)
                                             throw std::runtime_error("block 37");
                                         done[static_cast<std::size_t>(k)] = 1;
                                     }),
                        std::runtime_error);
        CHECK(std::accumulate(done.begin(), done.end(), 0) == others);
        CHECK_THROWS_AS(parallel_for(100, threads, [](int) { throw std::runtime_error("all"); }), std::runtime_error);
    }
}
TEST_CASE("a loop in a loop gets its blocks done by whoever is there") {
    std::vector<int> seen(20 * 30, 0);
    parallel_for(20, 4, [&](int outer) {
        parallel_for(30, 4, [&](int inner) { ++seen[static_cast<std::size_t>(30 * outer + inner)]; });
    });
    CHECK(seen == std::vector<int>(20 * 30, 1));
}
