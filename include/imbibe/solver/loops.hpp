// Loops over particles with bodies behind a pointer: the code for threads and exceptions is then compiled once, not for
// every loop, and a body once, not once with and once without threads.
#pragma once

#include <imbibe/core/parallel.hpp>

#include <algorithm>

namespace imbibe::detail {

/// A reference to a callable of this signature, which must outlive it.
template <class Signature>
class Callable;
template <class Result, class... Argument>
class Callable<Result(Argument...)> {
public:
    template <class F>
    explicit Callable(const F& f)
        : object_(&f), call_([](const void* object, Argument... argument) -> Result {
              return (*static_cast<const F*>(object))(argument...);
          }) {}
    Result operator()(Argument... argument) const { return call_(object_, argument...); }

private:
    const void* object_;
    Result (*call_)(const void*, Argument...);
};

/// parallel_blocks for bodies that take long compared with a call through a pointer.
[[gnu::noinline]] IMBIBE_PER_BUILD inline void loop_blocks(int n, int block, int threads,
                                                           const Callable<void(int, int)>& f) {
    parallel_blocks(n, block, threads, f);
}

/// The greatest of the numbers, at least 0, that f returns for blocks of n particles.
[[gnu::noinline]] IMBIBE_PER_BUILD inline double greatest_of_blocks(int n, int threads,
                                                                    const Callable<double(int, int)>& f) {
    return parallel_reduce(n, threads, 0.0, f, [](double one, double other) { return std::max(one, other); });
}

} // namespace imbibe::detail
