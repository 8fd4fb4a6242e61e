// Is a test compiled with a sanitizer? Such a build takes steps twenty times as long: what runs for minutes is then run
// for a part of its time, or not at all where the test names others that run the same loops.
#pragma once

#include <cstdio>

namespace imbibe_test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif
#else
inline constexpr bool sanitized = false;
#endif

/// Is a test, or the rest of it, left out where it takes too long with a sanitizer? Says so, and why.
inline bool left_out(const char* why) {
    if (sanitized)
        std::printf("left out with a sanitizer: %s\n", why);
    return sanitized;
}

} // namespace imbibe_test
