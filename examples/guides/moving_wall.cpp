// A wall that moves: a tank of water, shaken at the frequency at which the water sloshes, with a table of what it does.
//
//   build/guide_moving_wall; python3 tools/plot_curves.py out-moving-wall/sloshing.csv -o sloshing.png
#include <imbibe/imbibe.hpp>

#include <cstdio>
#include <numbers>

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<sph::LinearState, sph::WeaklyCompressible<K>, sph::MonaghanViscosity<K>> {};
struct Tank : sph::Wall<> {
    using motion = sph::Prescribed; // with the velocity that the program gives it
};
struct Contact : sph::CouplingOf<Water, Tank> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, Contact>;

int main() {
    const double dx = 0.02, length = 0.6, depth = 0.3, g = 9.81, pi = std::numbers::pi;
    Scene scene({.gravity = {0, -g}, .support_radius = 3 * dx});
    Water material{{.density = 1000, .sound_speed = 10 * std::sqrt(2 * g * depth)}};
    material.set(sph::MonaghanViscosityParameters{.alpha = 0.02});
    const auto water = scene.add(material, sph::fill(sph::Box<2>({0, 0}, {length, depth}), dx), dx);
    const auto tank = scene.add(Tank{{.density = 1000}},
                                sph::tank(sph::Box<2>({0, 0}, {length, 0.6}), dx, 3, sph::Sides::y_high), dx);
    sph::start_hydrostatic(scene, water, depth);

    // The tank is at x = amplitude (1 - cos(frequency t)): at rest at first, and then in step with the lowest wave,
    // which has half its length in the tank.
    const double k = pi / length, frequency = std::sqrt(g * k * std::tanh(k * depth)), amplitude = 0.005;
    const double end = 1.25 * 2 * pi / frequency;
    const auto centre = [&] { return scene[water][sph::position].col(0).mean(); };
    const double start = centre();

    sph::require_writable("out-moving-wall");
    sph::Table table("out-moving-wall/sloshing.csv", {{"time", "s"},
                                                      {"tank", "m"},
                                                      {"centre of the water in the tank", "m"},
                                                      {"pressure at the left wall", "Pa"},
                                                      {"height of the surface there", "m"}});
    const double tank_before = scene[tank][sph::position].col(0).mean();
    const auto tank_at = [&] { return scene[tank][sph::position].col(0).mean() - tank_before; };
    const auto shake = [&](Scene& now) {
        const double v = amplitude * frequency * std::sin(frequency * now.time());
        now[tank][sph::velocity].col(0).setConstant(v);
    };
    auto write = sph::every(0.01, [&](const Scene& now) {
        const double gauge = sph::value_at(now, water, sph::pressure, {tank_at(), depth / 2});
        const double height = sph::surface_height(now, water, {tank_at(), 0});
        table.row({now.time(), tank_at(), centre() - start - tank_at(), gauge, height});
    });
    scene.run_until(end, shake, write, sph::Guard<2>({.lower = {-0.1, -0.1}, .upper = {length + 0.1, 0.7}}));

    // Linear theory: of the water the share 8 tanh(k depth)/(pi^2 k depth) swings to and fro, and higher each time.
    const double share = 8 * std::tanh(k * depth) / (pi * pi * k * depth), phase = frequency * scene.time();
    const double theory = -share * amplitude / 2 * phase * std::sin(phase);
    const double found = centre() - start - tank_at();
    std::printf("the tank is at %.1f mm; the water's centre is %.2f mm from the tank's, in linear theory %.2f mm\n",
                1e3 * tank_at(), 1e3 * found, 1e3 * theory);
    return std::abs(found / theory - 1) < 0.1 ? 0 : 1;
}
