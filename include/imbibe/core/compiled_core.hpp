// Is code that knows no type of a scene read with the headers, or is it in the library imbibe::core? Headers with such
// code declare it; where it is to be compiled, they include their second half, <name>_code.hpp, with the definitions.
#pragma once

#ifdef IMBIBE_COMPILED_CORE // set for programs that link imbibe::core
#define IMBIBE_READS_CODE 0
#else
#define IMBIBE_READS_CODE 1
#endif

/// Stands before the definition of a function that is not a template.
#ifdef IMBIBE_CORE_SOURCE // in the file of imbibe::core with the definitions
#define IMBIBE_CODE
#else
#define IMBIBE_CODE inline
#endif
