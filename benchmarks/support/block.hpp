// A cube of one phase in motion, ready for its sweeps: what the benchmarks of the pair loop run on.
#pragma once

#include "cloud.hpp"
#include "working.hpp"

#include <imbibe/solver/solver.hpp>
#include <imbibe/time/symplectic_euler.hpp>

namespace imbibe::bench {

/// Gives the particles of a phase velocities that differ from neighbour to neighbour, up to 1 m/s, so that no term
/// meets only zeros.
void stir(const auto& phase, double spacing_) {
    auto v = phase[velocity];
    const auto x = phase[position];
    using Real = typename std::remove_cvref_t<decltype(v)>::Scalar;
    for (int i = 0; i < phase.size(); ++i)
        for (int d = 0; d < 3; ++d)
            v(i, d) = static_cast<Real>(std::sin(1.3 * (d + 1) * static_cast<double>(x(i, (d + 1) % 3)) / spacing_));
}

/// The loops of a step, without the search and without motion: the same work every time.
template <class Engine>
void run_loops(Engine& engine) {
    engine.template run<typename Engine::Composition::WholeStep>(0);
}

/// The engine of a scene with one phase, a cube of about `particles`, sorted and with its neighbours.
/// @param support the support radius in spacings
template <class Real, class Phase>
auto block(const Phase& phase, int particles, double support) {
    Solver<3, Real, SymplecticEuler, Phase> scene(
        {.gravity = {0, 0, -9.81}, .support_radius = support * spacing, .threads = 1});
    const auto handle = scene.add(phase, cube(particles), spacing);
    stir(scene[handle], spacing);
    scene.prepare();
    return scene.engine();
}
template <class Real, class Phase>
using Block = typename Solver<3, Real, SymplecticEuler, Phase>::Engine;

} // namespace imbibe::bench
