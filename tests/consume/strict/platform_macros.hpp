// Macros of common platforms' headers: <windows.h> and what it includes, X11, <complex.h>, <sys/sysmacros.h>, and what
// compilers define by themselves. No name of the library is one of them: a program may have included those headers before.
// What the standard library and Eigen call so is read first.
#pragma once

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <initializer_list>
#include <ios>
#include <iterator>
#include <limits>
#include <locale>
#include <map>
#include <memory>
#include <new>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <fcntl.h>
#include <unistd.h>
#ifdef _OPENMP
#include <omp.h>
#endif
#ifdef __SSE2__
#include <immintrin.h>
#endif

// <windows.h>: minwindef.h, windef.h, winnt.h, wingdi.h, winerror.h, rpcndr.h, combaseapi.h; min and max are calls of
// std::min and std::max in the library, for which programs on Windows define NOMINMAX.
#define near
#define far
#define NEAR near
#define FAR far
#define IN
#define OUT
#define OPTIONAL
#define CONST const
#define VOID void
#define CALLBACK
#define TRUE 1
#define FALSE 0
#define DELETE 0x00010000L
#define ERROR 0
#define NO_ERROR 0L
#define IGNORE 0
#define INFINITE 0xFFFFFFFF
#define ABSOLUTE 1
#define RELATIVE 2
#define TRANSPARENT 1
#define OPAQUE 2
#define STRICT 1
#define small char
#define hyper long long
#define interface struct
#define pascal
#define cdecl
#define GetObject GetObjectA
#define DrawText DrawTextA
#define LoadImage LoadImageA
#define SendMessage SendMessageA
#define Yield()
#define OVERFLOW 3
#define UNDERFLOW 4
#define DOMAIN 1
#define SING 2

// X11/X.h and X11/Xlib.h
#define None 0L
#define Bool int
#define Status int
#define True 1
#define False 0
#define Always 2
#define Success 0
#define Above 0
#define Below 1
#define Convex 2
#define Nonconvex 1
#define Unsorted 0
#define CurrentTime 0L

// <sys/sysmacros.h>
#define major(device) 0
#define minor(device) 0
#define makedev(larger, smaller) 0

// <complex.h>
#define I (__extension__ 1.0iF)
#define imaginary _Imaginary

// compilers without -std=c++20
#ifndef unix
#define unix 1
#endif
#ifndef linux
#define linux 1
#endif
