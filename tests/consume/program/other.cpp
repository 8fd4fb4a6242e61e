// The second file of the user's program: see main.cpp.
#if __has_include(<imbibe/imbibe.hpp>)
#include <imbibe/imbibe.hpp>
#endif
#include <imbibe/version.hpp>
#include <string>

std::string version_seen_by_the_other_file();

std::string version_seen_by_the_other_file() {
    return std::to_string(IMBIBE_VERSION_MAJOR) + "." + std::to_string(IMBIBE_VERSION_MINOR) + "." +
           std::to_string(IMBIBE_VERSION_PATCH);
}
