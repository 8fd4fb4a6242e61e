// A small scene, in a header that both files of the user's program include.
#pragma once

#include <imbibe/imbibe.hpp>
#include <string>

struct Water : imbibe::Fluid<imbibe::Tait<7>, imbibe::Continuity<imbibe::WendlandC2>,
                             imbibe::SymmetricPressure<imbibe::WendlandC2>> {};

/// Lets a drop fall for five steps of 0.1 ms. Returns how far its mean height has changed, m.
inline double height_of_a_drop() {
    constexpr double spacing = 0.1, g = 9.8, dt = 1e-4;
    imbibe::Solver<2, double, imbibe::SymplecticEuler, Water> scene(
        {.gravity = {0, -g}, .support_radius = 2.6 * spacing});
    const auto water = scene.add(Water{{.density = 1000, .sound_speed = 30}},
                                 imbibe::fill(imbibe::Sphere<2>{{0, 0}, 0.35}, spacing), spacing);
    const double before = scene[water][imbibe::position].col(1).mean();
    for (int k = 0; k < 5; ++k)
        scene.step(dt);
    return scene[water][imbibe::position].col(1).mean() - before;
}

/// Compiled into the other file.
std::string version_seen_by_the_other_file();
double height_in_the_other_file();
