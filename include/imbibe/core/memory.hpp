// Memory for long columns of numbers: it begins on a cache line, and where it is long, on a huge page.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace imbibe {

/// An allocator of memory that begins on a cache line, so that the packs of a loop over all particles do. Stretches of
/// several huge pages begin on one, and the system is asked to use them (Linux's transparent huge pages, where they are
/// left to `madvise`): with ten million particles a step is full of places whose pages the processor must look up
/// first, and new memory is there after one interruption where it would have taken 512.
template <class T>
struct AlignedAllocator {
    /// What it makes room for.
    using value_type = T;
    /// Bytes of a huge page of nearly all processors.
    static constexpr std::size_t huge_page = std::size_t(1) << 21;
    AlignedAllocator() = default;
    /// Any is as good as any other.
    template <class U>
    AlignedAllocator(const AlignedAllocator<U>&) {}
    /// Memory for n numbers. Throws std::bad_alloc when there is none.
    T* allocate(std::size_t n) {
        if (n > static_cast<std::size_t>(-1) / sizeof(T))
            throw std::bad_array_new_length();
        void* const place = ::operator new(n * sizeof(T), alignment(n));
#ifdef MADV_HUGEPAGE
        if (is_long(n)) // an advice: where it is not taken, all works as before
            static_cast<void>(::madvise(place, n * sizeof(T) / huge_page * huge_page, MADV_HUGEPAGE));
#endif
        return static_cast<T*>(place);
    }
    /// Gives memory for n numbers back.
    void deallocate(T* place, std::size_t n) {
        ::operator delete(place, alignment(n));
    }
    /// Any may give back what another has given.
    friend bool operator==(const AlignedAllocator&, const AlignedAllocator&) {
        return true;
    }

private:
    static bool is_long(std::size_t n) {
        return n * sizeof(T) >= 4 * huge_page;
    }
    static std::align_val_t alignment(std::size_t n) {
        return std::align_val_t{is_long(n) ? huge_page : 64};
    }
};

/// Numbers one after the other, from a cache line on.
template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

} // namespace imbibe
