// Half a metre of water on a soft elastic plate, 1 m wide and 0.05 m thick, clamped at both ends. After Fourey et al.
// (2017), with a softer plate and less water. Measured: how far its middle hangs down, as a share of the same plate's
// under the same weight without water, so that 1 is right for a coupling, however fine the plate.
#pragma once

#include "run.hpp"

namespace couplings::plate {

constexpr double gravity = 9.81, depth = 0.5, thickness = 0.05, density = 2700, young_modulus = 6.75e8, end = 0.16;
constexpr double damping = 120; // 1/s, a little below critical for the plate with the water on it
constexpr Load load{1000 * gravity * depth, 0.1};

/// @param modulus Young's modulus, Pa
template <class Kit>
auto add_plate(auto& scene, double spacing, double modulus = young_modulus) {
    const auto plate =
        scene.add(elastic<Kit>(modulus, 0.34, density, 1.5 * spacing),
                  sph::fill(sph::Box<2>{{-4 * spacing, -thickness}, {1 + 4 * spacing, 0}}, spacing), spacing);
    scene.hold(plate, [](const auto& x) { return x[0] < 0 || x[0] > 1; });
    return plate;
}

/// How far the middle of the plate hangs down, m.
double sag(const auto& plate) {
    const auto X = plate[sph::reference_position], x = plate[sph::position];
    double sum = 0;
    int number = 0;
    for (int i = 0; i < plate.size(); ++i)
        if (std::abs(X(i, 0) - 0.5) < plate.material().spacing) {
            sum += X(i, 1) - x(i, 1);
            ++number;
        }
    return sum / number;
}

/// The same plate under the weight of the water as a body force, m.
inline double dry_sag(double spacing, double modulus = young_modulus) {
    using Plate = Elastic<Extrapolated>;
    const double g = gravity * (1 + 1000 * depth / (density * thickness));
    sph::Solver<2, double, sph::SymplecticEuler, Plate> scene(
        {.gravity = {0, -g}, .support_radius = 1.5 * spacing, .threads = 1});
    auto plate = scene[add_plate<Extrapolated>(scene, spacing, modulus)];
    while (scene.time() < end)
        plate[sph::velocity] *= 1 - damping * scene.step();
    return sag(plate);
}

/// The sag over time with the water on it, m. @param modulus Young's modulus of the plate, Pa
template <class Kit>
Outcome wet_sag(const Numerics& numerics, double modulus = young_modulus) {
    const double dx = numerics.spacing, support = numerics.ratio * dx;
    const Layers layers{support, dx, dx / 2, 2};
    Scene<2, double, Kit> scene(
        {.gravity = {0, -gravity}, .support_radius = support, .cfl = numerics.cfl, .threads = 1});
    const double sound_speed = 10 * std::sqrt(2 * gravity * depth), low = Kit::first_gap(load, layers);
    const auto pool = scene[scene.add(water(sound_speed), sph::fill(sph::Box<2>{{0, low}, {1, low + depth}}, dx), dx)];
    const auto plate = scene[add_plate<Kit>(scene, dx / 2, modulus)];
    auto sides = sph::fill(sph::Box<2>{{-3 * dx, 0}, {0, 1.2 * depth}}, dx);
    for (const auto& x : sph::fill(sph::Box<2>{{1, 0}, {1 + 3 * dx, 1.2 * depth}}, dx))
        sides.push_back(x);
    scene.add(Walls{{.density = 1000}}, sides, dx);
    couple<Kit>(scene, load, layers);
    for (int i = 0; i < pool.size(); ++i)
        pool[sph::density](i) += 1000 * gravity * (low + depth - pool[sph::position](i, 1)) / sph::sq(sound_speed);
    return run<Kit>(
        scene, end, 8, [&](auto&) { return sag(plate); },
        [&](auto&, double step) {
            pool[sph::velocity] *= 1 - damping * step;
            plate[sph::velocity] *= 1 - damping * step;
        });
}

template <class Kit>
Outcome run_with(const Numerics& numerics) {
    Outcome outcome = wet_sag<Kit>(numerics);
    if (outcome.failure.empty())
        outcome.value = outcome.curve.back() / dry_sag(numerics.spacing / 2);
    return outcome;
}

} // namespace couplings::plate
