// A user's program in two files that both include all of imbibe and run the same scene: it must link, both must see
// the same version and come to the same result.
#include "drop.hpp"
#include <cmath>
#include <iostream>

int main() {
    const std::string version = std::to_string(IMBIBE_VERSION_MAJOR) + "." + std::to_string(IMBIBE_VERSION_MINOR) +
                                "." + std::to_string(IMBIBE_VERSION_PATCH);
    std::cout << "imbibe " << version << ", the package says " << EXPECTED_VERSION << "\n";
    bool good = version == EXPECTED_VERSION && version == version_seen_by_the_other_file();

    // Five steps of symplectic Euler: the drop falls g dt^2 (1 + 2 + 3 + 4 + 5).
    const double expected = -9.8 * 1e-8 * 15;
    const double height = height_of_a_drop();
    std::cout << "a drop is " << height << " m lower; by free fall " << expected << " m\n";
    good = good && std::abs(height - expected) < 1e-12 && height == height_in_the_other_file();
    return good ? 0 : 1;
}
