// Compiler hints that the language has no word for: inline, assume, unroll.
#pragma once

// Before a function, or behind the parameters of a lambda, that is to be inlined wherever it is called.
#if defined(__GNUC__) || defined(__clang__)
#define IMBIBE_INLINE __attribute__((always_inline)) inline
#define IMBIBE_INLINE_LAMBDA __attribute__((always_inline))
#else
#define IMBIBE_INLINE inline
#define IMBIBE_INLINE_LAMBDA
#endif

// Tells the compiler that a condition always holds.
#if defined(__GNUC__) || defined(__clang__)
#define IMBIBE_ASSUME(condition)                                                                                       \
    do {                                                                                                               \
        if (!(condition))                                                                                              \
            __builtin_unreachable();                                                                                   \
    } while (false)
#else
#define IMBIBE_ASSUME(condition) static_cast<void>(0)
#endif

// Before a loop over the components of a vector or tensor: without it g++ may keep the loop, and the components in
// memory.
#if defined(__GNUC__) && !defined(__clang__)
#define IMBIBE_UNROLL _Pragma("GCC unroll 9")
#else
#define IMBIBE_UNROLL
#endif
