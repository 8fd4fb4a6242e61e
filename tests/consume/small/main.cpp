// The smallest program with a scene of its own: its water falls as far as everything does, and it bursts.
#include "scene.hpp"
#include <cmath>
#include <cstdio>

int main() {
    SmallScene scene = fallen_square();
    const auto x = scene.get<SmallWater>()[imbibe::position];
    // Inner forces cancel: the centre falls g dt^2 (1 + 2 + ... + n), whatever the water does.
    const double expected = -small_gravity * small_step * small_step * small_steps * (small_steps + 1) / 2;
    const double fallen = x.col(1).cast<double>().mean(), width = x.col(0).maxCoeff() - x.col(0).minCoeff();
    std::printf("imbibe %d.%d.%d: fallen by %g m, expected %g m; 1.9 m wide before, %g m now\n", IMBIBE_VERSION_MAJOR,
                IMBIBE_VERSION_MINOR, IMBIBE_VERSION_PATCH, fallen, expected, width);
    return std::abs(fallen - expected) < 1e-5 && width > 1.901 && width < 2.1 ? 0 : 1;
}
