// Dynamic relaxation: a hanging bar comes to rest where statics have it, sooner than by waiting.
#include <catch_shim.hpp>

#include <imbibe/geometry/fill.hpp>
#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/monitor/dynamic_relaxation.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/time/symplectic_euler.hpp>

namespace dynamic_relaxation_test {

using namespace imbibe;

struct Rubber : Solid<TotalLagrangianSolid<>, Clamped> {};

TEST_CASE("DynamicRelaxation brings a hanging bar to rest within three of its periods") {
    // Sheared sideways by its weight, u = rho g (l^2 - x^2)/(2 G); it swings with 4 l sqrt(rho/G) = 0.4 s.
    const double dx = 0.01, G = 1e5, rho = 1000, g = 10, length = 1, end = 1.2;
    Solver<2, float, SymplecticEuler, Rubber> scene({.gravity = {0, g},
                                                     .support_radius = 1.5 * dx,
                                                     .cfl = 0.5,
                                                     .periodic_length = {0, 0.05},
                                                     .search_interval = 7,
                                                     .threads = 1});
    const auto body = scene.add(Rubber{{.density = rho, .sound_speed = 12, .shear_modulus = G}},
                                fill(Box<2>({-2 * dx, 0}, {length, 0.05}), dx), dx);
    scene.hold(body, [](const auto& x) { return x[0] < 0; });
    DynamicRelaxation relaxation;
    scene.run_until(end, [&](auto& s) { relaxation(s[body], s.time()); });
    const auto view = scene[body];
    double moved = 0;
    for (int i = 0; i < view.size(); ++i)
        moved = std::max(moved, static_cast<double>(view[position](i, 1) - view[reference_position](i, 1)));
    CHECK(moved == Approx(rho * g * length * length / (2 * G)).epsilon(0.03));
    CHECK(static_cast<double>(view[velocity].cwiseAbs().maxCoeff()) < 1e-2 * moved / end);
    CHECK(relaxation.rate() >= 0);
}

} // namespace dynamic_relaxation_test
