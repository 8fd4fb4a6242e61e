// What the options a file is compiled with decide in the library: the width of packs, and threads. Names whose meaning
// depends on them are marked, so that files compiled with different options fit into one program.
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

#ifdef _OPENMP
#define IMBIBE_THREADS "openmp"
#else
#define IMBIBE_THREADS "one_thread"
#endif

/// Stands before the name of a class, or before the declaration of a function or variable, whose meaning depends on the
/// above, and makes that part of the linker's name for it and for everything that has it as an argument. Without it the
/// linker would take one of two different functions of one name, and a scene would be searched with packs of 16 and
/// summed with packs of 4.
#if IMBIBE_VECTOR_EXTENSION
#define IMBIBE_TEXT_OF_(x) #x
#define IMBIBE_TEXT_OF(x) IMBIBE_TEXT_OF_(x)
#define IMBIBE_PER_BUILD [[gnu::abi_tag("bytes" IMBIBE_TEXT_OF(IMBIBE_PACK_BYTES), IMBIBE_THREADS)]]
#else
#define IMBIBE_PER_BUILD
#endif
