// Memory for columns of numbers: it begins on a cache line.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace imbibe {

/// An allocator whose memory begins on a cache line, so that the packs of a loop over all particles do. The page size
/// is left to the system: with huge pages the steps of `benchmarks/bench_steps` take a tenth longer (a virtual machine,
/// AMD Zen 5), and much longer where only a part of the memory has them.
template <class T>
struct AlignedAllocator {
    /// The type of the numbers.
    using value_type = T;
    AlignedAllocator() = default;
    /// All allocators are interchangeable.
    template <class U>
    AlignedAllocator(const AlignedAllocator<U>&) {}
    /// Memory for n numbers. Throws std::bad_alloc if there is not enough.
    T* allocate(std::size_t n) {
        if (n > static_cast<std::size_t>(-1) / sizeof(T))
            throw std::bad_array_new_length();
        return static_cast<T*>(::operator new(n * sizeof(T), alignment));
    }
    /// Frees memory for n numbers.
    void deallocate(T* place, std::size_t) { ::operator delete(place, alignment); }
    /// Always true: any allocator may free what another has allocated.
    friend bool operator==(const AlignedAllocator&, const AlignedAllocator&) { return true; }

private:
    static constexpr std::align_val_t alignment{64};
};

/// A vector of numbers that begins on a cache line.
template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

} // namespace imbibe
