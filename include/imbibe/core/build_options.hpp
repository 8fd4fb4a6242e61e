// What the compile options of a file decide in the library: the width of packs, how they are computed, and threads.
// Names whose meaning or code depends on the options are marked, so that files compiled with different options can be
// linked into one program.
#pragma once

#if (defined(__GNUC__) || defined(__clang__)) && !defined(__CUDACC__)
#define IMBIBE_VECTOR_EXTENSION 1
#else
#define IMBIBE_VECTOR_EXTENSION 0
#endif

/// The size of the instruction set's widest vector register, bytes; 1: packs hold one number.
#if IMBIBE_VECTOR_EXTENSION && defined(__AVX512F__)
#define IMBIBE_PACK_BYTES 64
#elif IMBIBE_VECTOR_EXTENSION && defined(__AVX__)
#define IMBIBE_PACK_BYTES 32
#elif IMBIBE_VECTOR_EXTENSION && (defined(__SSE2__) || defined(__ARM_NEON))
#define IMBIBE_PACK_BYTES 16
#else
#define IMBIBE_PACK_BYTES 1
#endif

// Should quotients and roots of whole AVX-512 registers start from the processor's estimate? On most processors the
// exact instructions stall the pipeline. On Zen they run beside the multiply-adds, and estimate plus Newton steps cost
// a tenth of a pair loop (docs/speed.md). Compilers that do not know Zen 4 take it for a Zen 3 with AVX-512.
#if IMBIBE_VECTOR_EXTENSION && defined(__AVX512F__) && !defined(__znver3__) && !defined(__znver4__) &&                 \
    !defined(__znver5__)
#define IMBIBE_ESTIMATES 1
#else
#define IMBIBE_ESTIMATES 0
#endif

// Other macros that show what changes the bits of a result or the processors that can run it: one word each.
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

/// Marks a class, function or variable whose meaning or code depends on the above: that becomes part of its linker
/// name, and of the name of everything that takes it as an argument. Without the mark the linker would take one of two
/// different functions of the same name: a scene would be searched with packs of 16 and summed with packs of 4, or
/// compiled for one processor and run by another.
#if IMBIBE_VECTOR_EXTENSION
#define IMBIBE_TEXT_OF_(x) #x
#define IMBIBE_TEXT_OF(x) IMBIBE_TEXT_OF_(x)
#define IMBIBE_PER_BUILD                                                                                               \
    [[gnu::abi_tag("bytes" IMBIBE_TEXT_OF(IMBIBE_PACK_BYTES)                                                           \
                       IMBIBE_WORD_AVX2 IMBIBE_WORD_FMA IMBIBE_WORD_ESTIMATES IMBIBE_WORD_FAST IMBIBE_WORD_THREADS)]]
#else
#define IMBIBE_PER_BUILD
#endif
