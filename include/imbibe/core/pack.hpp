// The number type of the pair loop: one number, or as many as the processor computes at once (a SIMD pack).
//
// A term's function is a template over its numbers and never mentions this class. The pair loop hands it
// Pack<Real, width> with the width of the machine (`native_width`), the particle loop Pack<Real, 1>. Built on the
// vector extension of g++ and clang; without it (or in device code) only width 1 is used. What can be computed with it
// beyond + - * / and comparisons is in pack_functions.hpp.
#pragma once

#include <imbibe/core/build_options.hpp>
#include <imbibe/core/compiler_hints.hpp>
#include <imbibe/core/rule.hpp>

#include <cstdint>
#include <type_traits>

#if IMBIBE_VECTOR_EXTENSION && defined(__SSE2__)
#include <immintrin.h>
#endif

namespace imbibe {

/// How many numbers of type Real this translation unit's instruction set computes at once.
template <class Real>
IMBIBE_PER_BUILD inline constexpr int native_width = IMBIBE_PACK_BYTES == 1
                                                         ? 1
                                                         : static_cast<int>(IMBIBE_PACK_BYTES / sizeof(Real));

namespace detail {

template <class Real, int width>
struct PackStorage {
#if IMBIBE_VECTOR_EXTENSION
    using type [[gnu::vector_size(sizeof(Real) * width)]] = Real; // not a typedef: GCC would drop the attribute
#endif
};
template <class Real>
struct PackStorage<Real, 1> {
    using type = Real;
};

template <class Real, int width>
struct MaskStorage {
    using Integer = std::conditional_t<sizeof(Real) == 4, std::int32_t, std::int64_t>;
#if IMBIBE_VECTOR_EXTENSION
    using type [[gnu::vector_size(sizeof(Real) * width)]] = Integer;
#endif
};
template <class Real>
struct MaskStorage<Real, 1> {
    using type = bool;
};

/// Are a pack's quotients and roots of this kind made from estimates?
template <class Real, int width>
inline constexpr bool estimates = IMBIBE_ESTIMATES != 0 && width * sizeof(Real) == 64;

#if IMBIBE_ESTIMATES
// Quotient and root from the processor's 14-bit estimates and Newton steps, each of which doubles the number of correct
// bits. The zero-masking forms with a full mask are the plain instructions; for the unmasked ones g++ 12 warns of an
// uninitialised value inside its own header.
using Floats = typename PackStorage<float, 16>::type;
using Doubles = typename PackStorage<double, 8>::type;

IMBIBE_INLINE Floats divide(Floats a, Floats b) {
    const auto y = Floats(_mm512_maskz_rcp14_ps(0xffff, __m512(b)));
    const Floats quotient = a * y;
    return quotient + y * (a - b * quotient);
}
IMBIBE_INLINE Doubles divide(Doubles a, Doubles b) {
    auto y = Doubles(_mm512_maskz_rcp14_pd(0xff, __m512d(b)));
    y += y * (1.0 - b * y);
    const Doubles quotient = a * y;
    return quotient + y * (a - b * quotient);
}
// The floor keeps the estimate finite at 0, where the result is x times it.
IMBIBE_INLINE Floats root(Floats x) {
    const auto least = _mm512_set1_ps(1e-37f);
    const auto y = Floats(_mm512_maskz_rsqrt14_ps(0xffff, _mm512_maskz_max_ps(0xffff, __m512(x), least)));
    const Floats estimate = x * y;
    return estimate + 0.5f * y * (x - estimate * estimate);
}
IMBIBE_INLINE Doubles root(Doubles x) {
    const auto least = _mm512_set1_pd(1e-300);
    const auto y = Doubles(_mm512_maskz_rsqrt14_pd(0xff, _mm512_maskz_max_pd(0xff, __m512d(x), least)));
    Doubles estimate = x * y, half = 0.5 * y;
    const Doubles error = 0.5 - estimate * half;
    estimate += estimate * error;
    half += half * error;
    return estimate + half * (x - estimate * estimate);
}
#endif

} // namespace detail

// Advice, printed as a template argument.
struct write_select_of_the_comparison_and_two_values;

namespace rules {
/// Rule: a term chooses between values with `select`, because its numbers may be packs.
template <class Advice>
struct NumbersAskedByIf {
    static_assert(sizeof(Advice*) == 0, "imbibe: a term compares its numbers in an `if`, by && or ?:, and they may be "
                                        "packs of several, of which some are so and some not");
};
} // namespace rules

/// The outcome of comparing two packs: one truth value per lane.
template <class Real, int width>
struct IMBIBE_PER_BUILD Mask {
    using Lanes = typename detail::MaskStorage<Real, width>::type;
    Lanes lanes;

    /// Does not compile, in one readable line; see `select`.
    template <class Advice = write_select_of_the_comparison_and_two_values>
    constexpr explicit operator bool() const {
        detail::break_rule<rules::NumbersAskedByIf<Advice>>();
        return true;
    }

    friend IMBIBE_INLINE constexpr Mask operator&(Mask a, Mask b) {
        if constexpr (width == 1)
            return {a.lanes && b.lanes};
        else
            return {a.lanes & b.lanes};
    }
    friend IMBIBE_INLINE constexpr Mask operator|(Mask a, Mask b) {
        if constexpr (width == 1)
            return {a.lanes || b.lanes};
        else
            return {a.lanes | b.lanes};
    }
};

/// `width` numbers of type Real that go through the same arithmetic. Plain numbers mix in and are converted to Real.
template <class Real, int width>
struct IMBIBE_PER_BUILD Pack {
    using Lanes = typename detail::PackStorage<Real, width>::type;
    using Scalar = Real;
    static constexpr int size = width;

    Lanes lanes;

    Pack() = default;
    /// The numbers of the lanes.
    IMBIBE_INLINE constexpr Pack(Lanes values) requires(width > 1) : lanes(values) {}
    /// The same number in every lane.
    template <class A>
        requires std::is_arithmetic_v<A>
    IMBIBE_INLINE constexpr Pack(A number) : lanes(broadcast(static_cast<Real>(number))) {}

    /// The numbers at `from`, `from + 1`, ...; they need not be aligned.
    IMBIBE_INLINE static constexpr Pack load(const Real* from) {
        if constexpr (width == 1) {
            return Pack(*from);
        } else {
            Pack p;
            __builtin_memcpy(&p.lanes, from, sizeof(Lanes));
            return p;
        }
    }
    /// Writes the lanes to `to`, `to + 1`, ...
    IMBIBE_INLINE constexpr void store(Real* to) const {
        if constexpr (width == 1)
            *to = lanes;
        else
            __builtin_memcpy(to, &lanes, sizeof(Lanes));
    }
    /// The number in lane k.
    IMBIBE_INLINE constexpr Real operator[]([[maybe_unused]] int k) const {
        if constexpr (width == 1)
            return lanes;
        else
            return lanes[k];
    }
    /// The number itself, for packs of one.
    IMBIBE_INLINE constexpr explicit operator Real() const requires(width == 1) { return lanes; }

    friend IMBIBE_INLINE constexpr Pack operator+(Pack a, Pack b) { return made(a.lanes + b.lanes); }
    friend IMBIBE_INLINE constexpr Pack operator-(Pack a, Pack b) { return made(a.lanes - b.lanes); }
    friend IMBIBE_INLINE constexpr Pack operator*(Pack a, Pack b) { return made(a.lanes * b.lanes); }
    /// Correctly rounded, except for whole AVX-512 registers on processors other than Zen: there it is the refined
    /// reciprocal, right to the last bit or the one before it, because the divider would stall the pipeline. In that
    /// case |b| must be from 1e-37 to 1e37.
    friend IMBIBE_INLINE constexpr Pack operator/(Pack a, Pack b) {
#if IMBIBE_ESTIMATES
        if constexpr (detail::estimates<Real, width>)
            if (!std::is_constant_evaluated())
                return made(detail::divide(a.lanes, b.lanes));
#endif
        return made(a.lanes / b.lanes);
    }
    friend IMBIBE_INLINE constexpr Pack operator-(Pack a) { return made(-a.lanes); }
    friend IMBIBE_INLINE constexpr Pack operator+(Pack a) { return a; }
    IMBIBE_INLINE constexpr Pack& operator+=(Pack b) { return *this = *this + b; }
    IMBIBE_INLINE constexpr Pack& operator-=(Pack b) { return *this = *this - b; }
    IMBIBE_INLINE constexpr Pack& operator*=(Pack b) { return *this = *this * b; }
    IMBIBE_INLINE constexpr Pack& operator/=(Pack b) { return *this = *this / b; }

    friend IMBIBE_INLINE constexpr Mask<Real, width> operator<(Pack a, Pack b) { return {a.lanes < b.lanes}; }
    friend IMBIBE_INLINE constexpr Mask<Real, width> operator>(Pack a, Pack b) { return {a.lanes > b.lanes}; }
    friend IMBIBE_INLINE constexpr Mask<Real, width> operator<=(Pack a, Pack b) { return {a.lanes <= b.lanes}; }
    friend IMBIBE_INLINE constexpr Mask<Real, width> operator>=(Pack a, Pack b) { return {a.lanes >= b.lanes}; }

private:
    IMBIBE_INLINE static constexpr Pack made(Lanes values) {
        Pack p{};
        p.lanes = values;
        return p;
    }
    IMBIBE_INLINE static constexpr Lanes broadcast(Real x) {
        if constexpr (width == 1)
            return x;
        else
            return x - Lanes{}; // minus zero leaves every number as it is, also -0
    }
};

/// One number with the interface of a pack: what particle functions receive.
template <class Real>
using Number = Pack<Real, 1>;

} // namespace imbibe
