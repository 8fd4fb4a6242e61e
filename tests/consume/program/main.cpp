// A user's program in two files that both include all of imbibe: it must link, and both must see the same version.
#if __has_include(<imbibe/imbibe.hpp>)
#include <imbibe/imbibe.hpp>
#endif
#include <imbibe/version.hpp>
#include <iostream>
#include <string>

std::string version_seen_by_the_other_file();

int main() {
    const std::string version = std::to_string(IMBIBE_VERSION_MAJOR) + "." + std::to_string(IMBIBE_VERSION_MINOR) +
                                "." + std::to_string(IMBIBE_VERSION_PATCH);
    std::cout << "imbibe " << version << ", the package says " << EXPECTED_VERSION << "\n";
    return version == EXPECTED_VERSION && version == version_seen_by_the_other_file() ? 0 : 1;
}
