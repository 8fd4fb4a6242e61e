// Numbers as files have them, for tests that make files in memory.
#pragma once

#include <algorithm>
#include <cstring>
#include <string>

namespace input_test {

/// Appends a number to some bytes, with its lowest byte first or last.
template <class T>
void append(std::string& bytes, T value, bool little = true) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (!little)
        std::reverse(raw, raw + sizeof(T));
    bytes.append(raw, sizeof(T));
}

} // namespace input_test
