// A small scene in the plane, quick to compile: a square of compressed water that falls and bursts.
#pragma once

#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/version.hpp>

struct SmallWater : imbibe::Fluid<imbibe::LinearState, imbibe::Continuity<imbibe::WendlandC2>,
                                  imbibe::VolumePressure<imbibe::WendlandC2>> {};
using SmallScene = imbibe::Solver<2, float, imbibe::SymplecticEuler, SmallWater>;

constexpr int small_steps = 32;
constexpr double small_step = 0x1p-10, small_gravity = 8;

/// 400 particles, 1 % denser than at rest, after 32 steps of a 1024th of a second.
[[maybe_unused]] static SmallScene fallen_square() {
    constexpr double dx = 0.1;
    SmallScene scene({.gravity = {0, -small_gravity}, .support_radius = 2.6 * dx});
    const auto water = scene.add(SmallWater{{.density = 1000, .sound_speed = 20}},
                                 imbibe::fill(imbibe::Box<2>({-1, -1}, {1, 1}), dx), dx);
    scene[water][imbibe::density].setConstant(1010);
    for (int k = 0; k < small_steps; ++k)
        scene.step(small_step);
    return scene;
}
