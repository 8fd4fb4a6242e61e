// A pore of an elastic block that closes under load, with water in it and without. Row 17 of the gauntlet.
#pragma once

#include "coupled.hpp"

namespace stability {

/// What is in the pore: nothing (the water is a drop beside the block), or water that can leave at one end.
enum class Pore { dry, wet };

/// An elastic block with a slot, 4 spacings wide, is squeezed by `value` spacings: its foot is held, and its head comes
/// down with 0.1 m/s as that of a testing machine. The guard is asked for pores of 2 particles. Row 17.
template <class C, Pore filled, class Real = double>
Outcome squeezed_pore(const Plan& plan) {
    constexpr double wide = 16 * dx, thick = 6 * dx, slot = 4 * dx, high = 2 * thick + slot;
    const double c = 30, way = plan.value * dx, v = 0.1, end = way / v;
    auto scene = coupled_scene<C, Real>(c);
    std::vector<sph::Point<2>> points, drop;
    for (const auto& x : sph::fill(sph::Box<2>{{0, 0}, {wide, high}}, dx))
        if (x[0] < 5 * dx || x[1] < thick || x[1] > thick + slot) // joined at the left, open at the right
            points.push_back(x);
    const auto block = add_body<C>(scene, points, 1e6, 0.3, 950);
    scene.hold(block, [=](const auto& x) { return x[1] < 2 * dx || x[1] > high - 2 * dx; });
    const double beside = filled == Pore::wet ? 0 : 20 * dx;
    add_water<typename C::Fluid>(
        scene, sph::fill(sph::Box<2>{{5 * dx + beside, thick}, {13 * dx + beside, thick + slot}}, dx), c);
    const double c_body = scene[block].material().longitudinal_wave_speed();
    const Watch<2> watch{
        .end = end,
        .guard = {.energy = std::numeric_limits<double>::infinity(), .least_pore = 2, .pore_interval = 10},
        .signs = {},
        .every = 1,
        .expected_steps = end * std::max(c, c_body) / dx};
    double lowered = 0;
    return march(scene, plan, watch, [&](const auto& s) {
        const double by = v * s.time() - lowered;
        auto view = scene[block];
        for (int i = 0; i < view.size(); ++i)
            if (view[sph::mobility](i) == 0 && points[view.ids()[static_cast<std::size_t>(i)]][1] > high / 2) {
                view[sph::position](i, 1) -= static_cast<Real>(by);
                view[sph::velocity](i, 1) = static_cast<Real>(-v);
            }
        lowered += by;
        return std::vector<double>{};
    });
}

} // namespace stability
