// The second file of the user's program: see main.cpp.
#include "drop.hpp"

std::string version_seen_by_the_other_file() {
    return std::to_string(IMBIBE_VERSION_MAJOR) + "." + std::to_string(IMBIBE_VERSION_MINOR) + "." +
           std::to_string(IMBIBE_VERSION_PATCH);
}

double height_in_the_other_file() {
    return height_of_a_drop();
}
