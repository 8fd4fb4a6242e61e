// Memory for columns of numbers: it begins on a cache line.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace imbibe {

/// An allocator of memory that begins on a cache line, so that the packs of a loop over all particles do. The size of
/// the pages of memory is left to the system: the steps of `benchmarks/bench_steps` took a tenth longer where it was
/// asked for huge ones (a virtual machine, AMD Zen 5), and much longer where only a part of the memory had them.
template <class T>
struct AlignedAllocator {
    /// What it makes room for.
    using value_type = T;
    AlignedAllocator() = default;
    /// Any is as good as any other.
    template <class U>
    AlignedAllocator(const AlignedAllocator<U>&) {}
    /// Memory for n numbers. Throws std::bad_alloc when there is none.
    T* allocate(std::size_t n) {
        if (n > static_cast<std::size_t>(-1) / sizeof(T))
            throw std::bad_array_new_length();
        return static_cast<T*>(::operator new(n * sizeof(T), alignment));
    }
    /// Gives memory for n numbers back.
    void deallocate(T* place, std::size_t) { ::operator delete(place, alignment); }
    /// Any may give back what another has given.
    friend bool operator==(const AlignedAllocator&, const AlignedAllocator&) { return true; }

private:
    static constexpr std::align_val_t alignment{64};
};

/// Numbers one after the other, from a cache line on.
template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

} // namespace imbibe
