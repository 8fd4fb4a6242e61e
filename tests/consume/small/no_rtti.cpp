// A program compiled with -fno-rtti: the whole library is, and reports and errors name types all the same.
#include "scene.hpp"
#include <cstdio>
#include <imbibe/imbibe.hpp>

int main() {
    SmallScene scene = fallen_square();
    const std::string report = imbibe::describe(scene);
    std::printf("%s", report.c_str());
    bool good = report.find("SmallWater: 400 particles") != std::string::npos &&
                report.find("LinearState, Continuity<WendlandC2") != std::string::npos;
    try {
        scene.add(SmallWater{{.density = -3, .sound_speed = 20}}, {}, 0.1);
        good = false;
    } catch (const imbibe::Error& error) {
        std::printf("%s\n", error.what());
        good = good && std::string(error.what()).find("SmallWater: density = -3") != std::string::npos;
    }
    return good ? 0 : 1;
}
