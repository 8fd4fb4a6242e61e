// Loops over particles whose bodies are behind a pointer: threads and exceptions are then compiled once, and not for
// every loop, and a body once instead of once with threads and once without.
#pragma once

#include <imbibe/core/parallel.hpp>

#include <algorithm>

namespace imbibe::detail {

/// Refers to something that can be called as the signature says. It must live as long.
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

/// parallel_blocks for calls that are long next to one through a pointer.
[[gnu::noinline]] IMBIBE_PER_BUILD inline void loop_blocks(int n, int block, int threads,
                                                           const Callable<void(int, int)>& f) {
    parallel_blocks(n, block, threads, f);
}

/// The greatest of the numbers, 0 or more, that f makes of blocks of n particles.
[[gnu::noinline]] IMBIBE_PER_BUILD inline double greatest_of_blocks(int n, int threads,
                                                                    const Callable<double(int, int)>& f) {
    return parallel_reduce(n, threads, 0.0, f, [](double one, double other) { return std::max(one, other); });
}

} // namespace imbibe::detail
