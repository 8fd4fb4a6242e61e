// Keeps the processor from slowing down on numbers that are almost zero.
#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace imbibe {

/// While it lives, this thread treats denormal numbers (below 1.2e-38 in float) as zero; its destructor restores the
/// former mode.
///
/// Differences that die out, such as velocities in a falling block or densities at rest, end as denormal numbers, and
/// each operation on one is far slower than usual. In float, the sponge scene has many of them while its water falls.
/// x86 only; on other machines it does nothing.
class [[maybe_unused]] DenormalsAreZero {
public:
#if defined(__SSE2__)
    DenormalsAreZero() : before(_mm_getcsr()) { _mm_setcsr(before | results_are_zero | operands_are_zero); }
    ~DenormalsAreZero() { _mm_setcsr(before); }

private:
    static constexpr unsigned results_are_zero = 0x8000, operands_are_zero = 0x0040;
    unsigned before;

public:
#else
    DenormalsAreZero() = default;
    ~DenormalsAreZero() = default;
#endif
    DenormalsAreZero(const DenormalsAreZero&) = delete;
    DenormalsAreZero& operator=(const DenormalsAreZero&) = delete;
};

} // namespace imbibe
