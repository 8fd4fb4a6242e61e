// What the options a file is compiled with decide in the library: the width of packs, how they are computed, and
// threads. Names whose meaning or code depends on them are marked, so that files compiled with different options fit
// into one program.
#pragma once

#if (defined(__GNUC__) || defined(__clang__)) && !defined(__CUDACC__)
#define IMBIBE_VECTOR_EXTENSION 1
#else
#define IMBIBE_VECTOR_EXTENSION 0
#endif

/// The bytes of the instruction set's longest register of numbers; 1: packs hold one number.
#if IMBIBE_VECTOR_EXTENSION && defined(__AVX512F__)
#define IMBIBE_PACK_BYTES 64
#elif IMBIBE_VECTOR_EXTENSION && defined(__AVX__)
#define IMBIBE_PACK_BYTES 32
#elif IMBIBE_VECTOR_EXTENSION && (defined(__SSE2__) || defined(__ARM_NEON))
#define IMBIBE_PACK_BYTES 16
#else
#define IMBIBE_PACK_BYTES 1
#endif

// Should quotients and roots of whole AVX-512 registers begin with the processor's estimate? On most processors the
// instructions hold up all else. On Zen they work beside the multiply-adds, and the estimate and its Newton's steps
// cost a tenth of a pair loop (docs/speed.md). Compilers that do not know Zen 4 take it for a Zen 3 that has AVX-512.
#if IMBIBE_VECTOR_EXTENSION && defined(__AVX512F__) && !defined(__znver3__) && !defined(__znver4__) &&                 \
    !defined(__znver5__)
#define IMBIBE_ESTIMATES 1
#else
#define IMBIBE_ESTIMATES 0
#endif

// What else changes the bits of a result, or the processors that can run it, and shows in a macro: a word of each.
#ifdef __AVX2__
#define IMBIBE_WORD_AVX2 "_avx2"
#else
#define IMBIBE_WORD_AVX2 ""
#endif
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
#define IMBIBE_WORD_FMA "_fma"
#else
#define IMBIBE_WORD_FMA ""
#endif
#if IMBIBE_ESTIMATES
#define IMBIBE_WORD_ESTIMATES "_estimates"
#else
#define IMBIBE_WORD_ESTIMATES ""
#endif
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#define IMBIBE_WORD_FAST "_fast"
#else
#define IMBIBE_WORD_FAST ""
#endif
#ifdef _OPENMP
#define IMBIBE_WORD_THREADS "_openmp"
#else
#define IMBIBE_WORD_THREADS ""
#endif

/// Stands before the name of a class, or before the declaration of a function or variable, whose meaning or code
/// depends on the above, and makes that part of the linker's name for it and for everything that has it as an argument.
/// Without it the linker would take one of two different functions of one name, and a scene would be searched with
/// packs of 16 and summed with packs of 4, or compiled for one processor and run by another.
#if IMBIBE_VECTOR_EXTENSION
#define IMBIBE_TEXT_OF_(x) #x
#define IMBIBE_TEXT_OF(x) IMBIBE_TEXT_OF_(x)
#define IMBIBE_PER_BUILD                                                                                               \
    [[gnu::abi_tag("bytes" IMBIBE_TEXT_OF(IMBIBE_PACK_BYTES)                                                           \
                       IMBIBE_WORD_AVX2 IMBIBE_WORD_FMA IMBIBE_WORD_ESTIMATES IMBIBE_WORD_FAST IMBIBE_WORD_THREADS)]]
#else
#define IMBIBE_PER_BUILD
#endif
