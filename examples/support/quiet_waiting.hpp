// Lets the threads of a program sleep while they wait for each other.
#pragma once

#include <cstdlib>
#if defined(__linux__)
#include <filesystem>
#include <system_error>
#include <unistd.h>
#endif

namespace imbibe::example {

/// Call it first in `main`. By default the idle threads of g++'s OpenMP spin; where another program wants a core too,
/// two threads are then several times slower than one. The runtime reads its environment before `main`, so the program
/// starts itself once more, with OMP_WAIT_POLICY=passive; threads then spin for some microseconds, in which most waits
/// end, and sleep. Where that cannot be done, or the user has set a policy, nothing happens.
inline void sleep_while_waiting([[maybe_unused]] char** argv) {
#if defined(__linux__)
    if (std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv("GOMP_SPINCOUNT") != nullptr)
        return;
    ::setenv("OMP_WAIT_POLICY", "passive", 1);
    ::setenv("GOMP_SPINCOUNT", "1000", 1);
    std::error_code unreadable; // by its own name, under which `ps` and `pkill` look for it
    if (const auto program = std::filesystem::read_symlink("/proc/self/exe", unreadable); !unreadable)
        ::execv(program.c_str(), argv);
    ::execv("/proc/self/exe", argv);
#endif
}

} // namespace imbibe::example
