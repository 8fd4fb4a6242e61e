// The functions of numbers that a term may call: roots, powers, extremes, choices. They act lane by lane on packs, and
// what is known at compile time costs nothing at run time.
#pragma once

#include <imbibe/core/pack.hpp>

#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace imbibe {

namespace detail {

// A square root that constant evaluation can pass through: there the value is irrelevant (dry runs of terms), so a
// few Newton steps from above are good enough.
template <class Real>
constexpr Real constant_sqrt(Real x) {
    if (!(x > 0))
        return Real(0);
    Real y = x > 1 ? x : Real(1);
    for (int k = 0; k < 64; ++k)
        y = (y + x / y) / 2;
    return y;
}

template <class Real>
IMBIBE_INLINE constexpr Real scalar_sqrt(Real x) {
    if (std::is_constant_evaluated())
        return constant_sqrt(x);
    return std::sqrt(x);
}

template <class Real, int width, class F>
IMBIBE_INLINE constexpr Pack<Real, width> lane_by_lane(Pack<Real, width> x, F f) {
    if constexpr (width == 1) {
        return Pack<Real, width>(f(x.lanes));
    } else {
        for (int k = 0; k < width; ++k)
            x.lanes[k] = f(x.lanes[k]);
        return x;
    }
}

} // namespace detail

/// a where the mask is true, b elsewhere.
template <class Real, int width>
IMBIBE_INLINE constexpr Pack<Real, width> select(Mask<Real, width> where, std::type_identity_t<Pack<Real, width>> a,
                                                 std::type_identity_t<Pack<Real, width>> b) {
    if constexpr (width == 1)
        return where.lanes ? a : b;
    else
        return Pack<Real, width>(static_cast<typename Pack<Real, width>::Lanes>(where.lanes ? a.lanes : b.lanes));
}
/// The same for plain numbers.
template <class A>
    requires std::is_floating_point_v<A>
IMBIBE_INLINE constexpr A select(bool where, A a, std::type_identity_t<A> b) {
    return where ? a : b;
}

// The zero-masking forms with a full mask below are the plain instructions; for the unmasked ones g++ 12 warns of an
// uninitialised value inside its own header.

namespace detail {

/// The greater or the smaller of two numbers, lane by lane. One instruction where the machine has one.
template <bool greater, class Real, int width>
IMBIBE_INLINE constexpr Pack<Real, width> extreme(Pack<Real, width> a, Pack<Real, width> b) {
    using P [[maybe_unused]] = Pack<Real, width>;
    [[maybe_unused]] const auto made = [](auto lanes) { return P(typename P::Lanes(lanes)); };
#if IMBIBE_VECTOR_EXTENSION && defined(__AVX512F__)
    if constexpr (width * sizeof(Real) == 64 && sizeof(Real) == 4) {
        const auto x = __m512(a.lanes), y = __m512(b.lanes);
        return made(greater ? _mm512_maskz_max_ps(0xffff, x, y) : _mm512_maskz_min_ps(0xffff, x, y));
    } else if constexpr (width * sizeof(Real) == 64) {
        const auto x = __m512d(a.lanes), y = __m512d(b.lanes);
        return made(greater ? _mm512_maskz_max_pd(0xff, x, y) : _mm512_maskz_min_pd(0xff, x, y));
    } else
#elif IMBIBE_VECTOR_EXTENSION && defined(__AVX__)
    if constexpr (width * sizeof(Real) == 32 && sizeof(Real) == 4) {
        const auto x = __m256(a.lanes), y = __m256(b.lanes);
        return made(greater ? _mm256_max_ps(x, y) : _mm256_min_ps(x, y));
    } else if constexpr (width * sizeof(Real) == 32) {
        const auto x = __m256d(a.lanes), y = __m256d(b.lanes);
        return made(greater ? _mm256_max_pd(x, y) : _mm256_min_pd(x, y));
    } else
#elif IMBIBE_VECTOR_EXTENSION && defined(__SSE2__)
    if constexpr (width * sizeof(Real) == 16 && sizeof(Real) == 4) {
        const auto x = __m128(a.lanes), y = __m128(b.lanes);
        return made(greater ? _mm_max_ps(x, y) : _mm_min_ps(x, y));
    } else if constexpr (width * sizeof(Real) == 16) {
        const auto x = __m128d(a.lanes), y = __m128d(b.lanes);
        return made(greater ? _mm_max_pd(x, y) : _mm_min_pd(x, y));
    } else
#endif
        // Not one expression with ?:, because g++ also reports errors in the branch not taken.
        if constexpr (greater)
            return select(a > b, a, b);
        else
            return select(a < b, a, b);
}

} // namespace detail

/// The larger of two numbers, lane by lane.
template <class Real, int width>
IMBIBE_INLINE constexpr Pack<Real, width> max(Pack<Real, width> a, std::type_identity_t<Pack<Real, width>> b) {
    return detail::extreme<true>(a, b);
}
/// The same for plain numbers.
template <class A>
    requires std::is_floating_point_v<A>
IMBIBE_INLINE constexpr A max(A a, std::type_identity_t<A> b) {
    return a > b ? a : b;
}

/// The smaller of two numbers, lane by lane.
template <class Real, int width>
IMBIBE_INLINE constexpr Pack<Real, width> min(Pack<Real, width> a, std::type_identity_t<Pack<Real, width>> b) {
    return detail::extreme<false>(a, b);
}
/// The same for plain numbers.
template <class A>
    requires std::is_floating_point_v<A>
IMBIBE_INLINE constexpr A min(A a, std::type_identity_t<A> b) {
    return a < b ? a : b;
}

/// max(x, 0): a compact kernel written with it is exactly zero outside its support, without a branch.
template <class T>
IMBIBE_INLINE constexpr T positive_part(T x) {
    return max(x, T(0));
}

/// min(x, 0)
template <class T>
IMBIBE_INLINE constexpr T negative_part(T x) {
    return min(x, T(0));
}

/// |x|
template <class T>
IMBIBE_INLINE constexpr T abs(T x) {
    return max(x, -x);
}

/// The square root of x >= 0. At width > 1 it needs no function call, unlike std::sqrt without -fno-math-errno. For
/// whole AVX-512 registers on processors other than Zen it uses Newton's method, right to the last bit and faster there
/// than the instruction.
template <class Real, int width>
IMBIBE_INLINE constexpr Pack<Real, width> sqrt(Pack<Real, width> a) {
    using P [[maybe_unused]] = Pack<Real, width>;
#if IMBIBE_ESTIMATES
    if constexpr (detail::estimates<Real, width>)
        return P(detail::root(a.lanes));
    else
#elif IMBIBE_VECTOR_EXTENSION && defined(__AVX512F__)
    if constexpr (width * sizeof(Real) == 64 && sizeof(Real) == 4)
        return P(typename P::Lanes(_mm512_maskz_sqrt_ps(0xffff, __m512(a.lanes))));
    else if constexpr (width * sizeof(Real) == 64)
        return P(typename P::Lanes(_mm512_maskz_sqrt_pd(0xff, __m512d(a.lanes))));
    else
#elif IMBIBE_VECTOR_EXTENSION && defined(__AVX__)
    if constexpr (width * sizeof(Real) == 32 && sizeof(Real) == 4)
        return P(typename P::Lanes(_mm256_sqrt_ps(__m256(a.lanes))));
    else if constexpr (width * sizeof(Real) == 32)
        return P(typename P::Lanes(_mm256_sqrt_pd(__m256d(a.lanes))));
    else
#elif IMBIBE_VECTOR_EXTENSION && defined(__SSE2__)
    if constexpr (width * sizeof(Real) == 16 && sizeof(Real) == 4)
        return P(typename P::Lanes(_mm_sqrt_ps(__m128(a.lanes))));
    else if constexpr (width * sizeof(Real) == 16)
        return P(typename P::Lanes(_mm_sqrt_pd(__m128d(a.lanes))));
    else
#endif
        return detail::lane_by_lane(a, [](Real number) { return detail::scalar_sqrt(number); });
}
/// The same for plain numbers.
template <class A>
    requires std::is_floating_point_v<A>
IMBIBE_INLINE constexpr A sqrt(A x) {
    return detail::scalar_sqrt(x);
}

/// x to the power n for an integer n known at compile time, by repeated squaring.
template <int n, class T>
IMBIBE_INLINE constexpr T power(T x) {
    if constexpr (n < 0)
        return T(1) / power<-n>(x);
    else if constexpr (n == 0)
        return T(1);
    else if constexpr (n % 2 == 1)
        return n == 1 ? x : x * power<n - 1>(x);
    else {
        const T half = power<n / 2>(x);
        return half * half;
    }
}

/// The cube root of x >= 0, at compile time too.
constexpr double cube_root(double x) {
    if (!std::is_constant_evaluated())
        return std::cbrt(x);
    if (!(x > 0))
        return 0;
    double root = 1;
    while (root * root * root < x)
        root *= 2;
    while (root * root * root > 8 * x)
        root /= 2;
    for (int k = 0; k < 8; ++k) // Newton's method: from at most twice the root, each step squares the error
        root -= (root - x / (root * root)) / 3;
    return root;
}

/// x squared.
template <class T>
IMBIBE_INLINE constexpr T sq(T x) {
    return x * x;
}

/// x to the power of `exponent`, lane by lane as std::pow has it (0, negative numbers, infinities and NaN too): slow, for
/// particle functions only. A plain number is the exponent of every lane: `pow(J, -2.0 / 3)`, `pow(J, T(-2.0 / 3))`.
template <class Real, int width>
IMBIBE_INLINE constexpr Pack<Real, width> pow(Pack<Real, width> x, std::type_identity_t<Pack<Real, width>> exponent) {
    Pack<Real, width> result = x; // in constant evaluation too, where the value is irrelevant (dry runs of terms)
    if (!std::is_constant_evaluated()) {
        if constexpr (width == 1)
            result.lanes = std::pow(x.lanes, exponent.lanes);
        else
            for (int k = 0; k < width; ++k)
                result.lanes[k] = std::pow(x.lanes[k], exponent.lanes[k]);
    }
    return result;
}
/// The same with one base for all lanes: `pow(2, x)`.
template <class A, class Real, int width>
    requires std::is_arithmetic_v<A>
IMBIBE_INLINE constexpr Pack<Real, width> pow(A x, Pack<Real, width> exponent) {
    return pow(Pack<Real, width>(x), exponent);
}
/// The same for plain numbers.
template <class A>
    requires std::is_floating_point_v<A>
IMBIBE_INLINE constexpr A pow(A x, std::type_identity_t<A> exponent) {
    return std::is_constant_evaluated() ? x : std::pow(x, exponent);
}

/// The exponential, lane by lane as std::exp has it: slow, for particle functions only.
template <class Real, int width>
IMBIBE_INLINE constexpr Pack<Real, width> exp(Pack<Real, width> x) {
    return detail::lane_by_lane(x, [](Real y) { return std::is_constant_evaluated() ? y : std::exp(y); });
}
/// The same for plain numbers.
template <class A>
    requires std::is_floating_point_v<A>
IMBIBE_INLINE constexpr A exp(A x) {
    return std::is_constant_evaluated() ? x : std::exp(x);
}

namespace detail {
#if IMBIBE_VECTOR_EXTENSION
template <int first, class Real, int width, std::size_t... k>
IMBIBE_INLINE Pack<Real, width / 2> half_of(Pack<Real, width> x, std::index_sequence<k...>) {
#if __has_builtin(__builtin_shufflevector)
    return Pack<Real, width / 2>(__builtin_shufflevector(x.lanes, x.lanes, (first + static_cast<int>(k))...));
#else // g++ 11
    return Pack<Real, width / 2>(typename PackStorage<Real, width / 2>::type{x.lanes[first + static_cast<int>(k)]...});
#endif
}
#endif
} // namespace detail

/// The sum over the lanes, always in the same order (a binary tree).
template <class Real, int width>
IMBIBE_INLINE constexpr Real sum(Pack<Real, width> x) {
    if constexpr (width == 1) {
        return x.lanes;
    } else if constexpr (width == 2) {
        return x.lanes[0] + x.lanes[1];
    } else {
        constexpr std::make_index_sequence<static_cast<std::size_t>(width / 2)> lanes{};
        return sum(detail::half_of<0>(x, lanes) + detail::half_of<width / 2>(x, lanes));
    }
}

/// One bit per lane, set where a < b.
template <class Real, int width>
IMBIBE_INLINE std::uint32_t less_bits(Pack<Real, width> a, Pack<Real, width> b) {
#if IMBIBE_VECTOR_EXTENSION && defined(__AVX512F__)
    if constexpr (width * sizeof(Real) == 64 && sizeof(Real) == 4)
        return _mm512_cmp_ps_mask(__m512(a.lanes), __m512(b.lanes), _CMP_LT_OQ);
    else if constexpr (width * sizeof(Real) == 64)
        return _mm512_cmp_pd_mask(__m512d(a.lanes), __m512d(b.lanes), _CMP_LT_OQ);
    else
#elif IMBIBE_VECTOR_EXTENSION && defined(__AVX__)
    if constexpr (width * sizeof(Real) == 32 && sizeof(Real) == 4)
        return static_cast<std::uint32_t>(
            _mm256_movemask_ps(_mm256_cmp_ps(__m256(a.lanes), __m256(b.lanes), _CMP_LT_OQ)));
    else if constexpr (width * sizeof(Real) == 32)
        return static_cast<std::uint32_t>(
            _mm256_movemask_pd(_mm256_cmp_pd(__m256d(a.lanes), __m256d(b.lanes), _CMP_LT_OQ)));
    else
#elif IMBIBE_VECTOR_EXTENSION && defined(__SSE2__)
    if constexpr (width * sizeof(Real) == 16 && sizeof(Real) == 4)
        return static_cast<std::uint32_t>(_mm_movemask_ps(_mm_cmplt_ps(__m128(a.lanes), __m128(b.lanes))));
    else if constexpr (width * sizeof(Real) == 16)
        return static_cast<std::uint32_t>(_mm_movemask_pd(_mm_cmplt_pd(__m128d(a.lanes), __m128d(b.lanes))));
    else
#endif
    {
        std::uint32_t bits = 0;
        for (int k = 0; k < width; ++k)
            bits |= static_cast<std::uint32_t>(a[k] < b[k]) << k;
        return bits;
    }
}

/// Writes the lanes, truncated to integers, to `to`.
template <int width>
IMBIBE_INLINE void truncate(Pack<float, width> x, std::int32_t* to) {
    if constexpr (width == 1) {
        *to = static_cast<std::int32_t>(x.lanes);
    } else {
        const auto whole = __builtin_convertvector(x.lanes, typename detail::MaskStorage<float, width>::type);
        __builtin_memcpy(to, &whole, sizeof(whole));
    }
}

/// a in the first `count` lanes, b in the others.
template <class Real, int width>
IMBIBE_INLINE Pack<Real, width> select_first(unsigned count, Pack<Real, width> a, Pack<Real, width> b) {
    Real numbers[static_cast<std::size_t>(width)];
    for (int k = 0; k < width; ++k)
        numbers[k] = static_cast<Real>(k);
    return select(Pack<Real, width>::load(numbers) < Pack<Real, width>(static_cast<Real>(count)), a, b);
}

} // namespace imbibe
